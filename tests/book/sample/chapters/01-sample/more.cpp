/***
## Figure 1

{{fig-1}}
*/
int from_the_other_file = 1;

/*** A long function: */
// Counts to sixty, slowly.
int sixty() {
  int n = 0;
  n += 1;
  n += 2;
  n += 3;
  n += 4;
  n += 5;
  n += 6;
  n += 7;
  n += 8;
  n += 9;
  n += 10;
  n += 11;
  n += 12;
  n += 13;
  n += 14;
  n += 15;
  n += 16;
  n += 17;
  n += 18;
  n += 19;
  n += 20;
  n += 21;
  n += 22;
  n += 23;
  n += 24;
  n += 25;
  n += 26;
  n += 27;
  n += 28;
  n += 29;
  n += 30;
  n += 31;
  n += 32;
  n += 33;
  n += 34;
  n += 35;
  n += 36;
  n += 37;
  n += 38;
  n += 39;
  n += 40;
  n += 41;
  n += 42;
  n += 43;
  n += 44;
  n += 45;
  n += 46;
  n += 47;
  n += 48;
  n += 49;
  n += 50;
  n += 51;
  n += 52;
  n += 53;
  n += 54;
  n += 55;
  n += 56;
  n += 57;
  n += 58;
  return n;
}

/*** Two of them: */
struct Pair {
  int a1;
  int a2;
  int a3;
  int a4;
  int a5;
  int a6;
  int a7;
  int a8;
  int a9;
  int a10;
  int a11;
  int a12;
  int a13;
  int a14;
  int a15;
  int a16;
  int a17;
  int a18;
  int a19;
  int a20;
  int a21;
  int a22;
  int a23;
  int a24;
  int a25;
  int a26;
  int a27;
  int a28;
  int a29;
  int a30;
  int a31;
  int a32;
  int a33;
  int a34;
  int a35;
  int a36;
  int a37;
  int a38;
  int a39;
};

int first(const Pair& p) {
  int n = 0;
  n += p.a1;
  n += p.a2;
  n += p.a3;
  n += p.a4;
  n += p.a5;
  n += p.a6;
  n += p.a7;
  n += p.a8;
  n += p.a9;
  n += p.a10;
  n += p.a11;
  n += p.a12;
  n += p.a13;
  n += p.a14;
  n += p.a15;
  n += p.a16;
  n += p.a17;
  n += p.a18;
  n += p.a19;
  n += p.a20;
  n += p.a21;
  n += p.a22;
  n += p.a23;
  n += p.a24;
  return n;
}
