// A headless Chromium, spoken to through pipes: nothing to install but the browser itself.
import {spawn} from "node:child_process";
import {existsSync, mkdtempSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {delimiter, join} from "node:path";

// The browser of this machine, or undefined; $CHROMIUM names another.
export function chromium() {
  if (process.env.CHROMIUM) return process.env.CHROMIUM;
  const names = ["chromium", "chromium-browser", "google-chrome"];
  const places = (process.env.PATH ?? "").split(delimiter).flatMap((folder) => names.map((name) => join(folder, name)));
  return places.find((place) => existsSync(place));
}

export class Browser {
  constructor(path) {
    this.profile = mkdtempSync(join(tmpdir(), "book-test-"));
    this.process = spawn(path, ["--headless=new", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe", "--no-first-run",
      "--disable-background-networking", "--user-data-dir=" + this.profile], {stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"]});
    this.next = 0;
    this.waiting = new Map();
    this.listeners = [];
    let text = "";
    this.process.stdio[4].setEncoding("utf8").on("data", (more) => {
      text += more;
      for (let end = text.indexOf("\0"); end >= 0; end = text.indexOf("\0")) {
        this.receive(JSON.parse(text.slice(0, end)));
        text = text.slice(end + 1);
      }
    });
  }

  receive(message) {
    if (message.id === undefined) {
      this.listeners.forEach((listener) => listener(message));
      return;
    }
    const {done, failed} = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if (message.error) failed(new Error(message.error.message)); else done(message.result);
  }

  send(method, params = {}, sessionId = this.session) {
    const id = ++this.next;
    this.process.stdio[3].write(JSON.stringify({id, method, params, sessionId}) + "\0");
    return new Promise((done, failed) => this.waiting.set(id, {done, failed}));
  }

  // A tab, with what goes wrong in it kept in `complaints`.
  async open() {
    const {targetId} = await this.send("Target.createTarget", {url: "about:blank"}, undefined);
    ({sessionId: this.session} = await this.send("Target.attachToTarget", {targetId, flatten: true}, undefined));
    this.complaints = [];
    this.requests = [];
    this.listeners.push(({method, params}) => {
      if (method === "Runtime.exceptionThrown") this.complaints.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
      if (method === "Log.entryAdded" && params.entry.level === "error") this.complaints.push(params.entry.text + " " + (params.entry.url ?? ""));
      if (method === "Network.requestWillBeSent") this.requests.push(params.request.url);
      if (method === "Network.loadingFailed" && !params.canceled) this.complaints.push("not loaded: " + params.errorText);
    });
    for (const domain of ["Page", "Runtime", "Log", "Network"]) await this.send(domain + ".enable");
  }

  async go(url) {
    const loaded = new Promise((done) => {
      const listener = ({method}) => {
        if (method !== "Page.loadEventFired") return;
        this.listeners.splice(this.listeners.indexOf(listener), 1);
        done();
      };
      this.listeners.push(listener);
    });
    await this.send("Page.navigate", {url});
    await loaded;
  }

  async width(width, height = 800) {
    await this.send("Emulation.setDeviceMetricsOverride", {width, height, deviceScaleFactor: 1, mobile: false});
  }

  // The value of an expression on the page, a promise's when it is one.
  async run(expression) {
    const {result, exceptionDetails} = await this.send("Runtime.evaluate", {expression, awaitPromise: true, returnByValue: true});
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  async picture(options = {}) {
    return Buffer.from((await this.send("Page.captureScreenshot", options)).data, "base64");
  }

  async close() {
    await this.send("Browser.close", {}, undefined).catch(() => {});
    await new Promise((done) => { this.process.once("exit", done); setTimeout(() => { this.process.kill("SIGKILL"); done(); }, 3000); });
    rmSync(this.profile, {recursive: true, force: true, maxRetries: 5});
  }
}
