// Runs a program and returns its output line by line, both streams together.
import { spawn } from "node:child_process";
import readline from "node:readline";

// After `seconds` a hanging program is killed, and `ending` records that.
export function run([program, ...args], { seconds = 600, onLine = () => {} } = {}) {
  return new Promise((resolve) => {
    const child = spawn(program, args, { stdio: ["ignore", "pipe", "pipe"] });
    const lines = [];
    let late = false;
    const timer = setTimeout(() => {
      late = true;
      child.kill("SIGKILL");
    }, seconds * 1000);
    for (const stream of [child.stdout, child.stderr]) {
      readline.createInterface({ input: stream }).on("line", (line) => {
        lines.push(line);
        onLine(line);
      });
    }
    const end = (status, ending) => {
      clearTimeout(timer);
      resolve({ lines, status, ending });
    };
    child.on("error", (error) => end(null, error.message));
    child.on("close", (status, signal) => {
      if (late) end(null, `no end after ${Math.round(seconds)} seconds`);
      else end(status, signal ? `signal ${signal}` : `exit status ${status}`);
    });
  });
}
