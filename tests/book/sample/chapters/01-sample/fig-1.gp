load "style.gp"
