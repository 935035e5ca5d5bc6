// SPDX-License-Identifier: GPL-3.0-or-later
//
// A reader of pages: a folder for programs and pages, calls of ncsim, a browser without network, and
// expectations. Requests and messages of the console are kept until the end.
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { chromium } from "playwright-core";

export class Reader {
  // `pictures`: folder for screenshots; undefined: none.
  constructor(name, ncsim, browserPath, pictures) {
    Object.assign(this, { ncsim, browserPath, pictures, failures: 0, requests: [], errors: [] });
    this.mayLog = true; // Other messages than errors and warnings; those of WebGL are such.
    this.folder = mkdtempSync(join(tmpdir(), `ncsim-${name}-`));
    if (pictures) mkdirSync(pictures, { recursive: true });
  }

  expect(condition, message) {
    if (condition) return;
    console.error(message);
    this.failures += 1;
  }
  same(a, b, message) {
    const [x, y] = [JSON.stringify(a), JSON.stringify(b)];
    this.expect(x === y, `${message}: ${x}, not ${y}`);
  }
  near(a, b, most, message) { this.expect(Math.abs(a - b) <= most, `${message}: ${a}, not ${b}`); }

  // Runs ncsim in the folder and returns the exit code.
  call(...words) {
    try {
      execFileSync(this.ncsim, words, { cwd: this.folder, stdio: "ignore" });
      return 0;
    } catch (error) {
      return error.status;
    }
  }

  // Opens a file of the folder in a new window.
  async open(file, options = {}) {
    this.browser ??= await chromium.launch({
      executablePath: this.browserPath,
      args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
    });
    const context = await this.browser.newContext(
      { viewport: { width: 1280, height: 900 }, offline: true, ...options });
    const page = await context.newPage();
    page.on("request", (request) => this.requests.push(request.url()));
    page.on("pageerror", (error) => this.errors.push(error.message));
    page.on("console", (message) => {
      const isFault = message.type() === "error" || message.type() === "warning";
      if (isFault || !this.mayLog) this.errors.push(message.text());
    });
    await page.goto(`file://${join(this.folder, file)}`);
    return page;
  }
  async picture(page, name, options = { fullPage: true }) {
    if (this.pictures) await page.screenshot({ path: join(this.pictures, `${name}.png`), ...options });
  }

  // Runs `read`; then no message of the console and no request but those that `isExpected` accepts
  // are allowed. Sets the exit code.
  async run(read, isExpected) {
    try {
      await read();
    } finally {
      await this.browser?.close();
    }
    for (const url of this.requests) this.expect(isExpected(url), `${url} was requested`);
    for (const error of this.errors) this.expect(false, `console: ${error}`);
    rmSync(this.folder, { recursive: true });
    process.exitCode = this.failures === 0 ? 0 : 1;
  }
}
