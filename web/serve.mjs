// Serves a folder on this computer only, as a plain static host would:
//   node web/serve.mjs FOLDER [PORT]
// If the port is taken, the next free one is used. Every answer has the content security policy under which the page
// must also work elsewhere.
import { createReadStream } from "node:fs";
import { realpath, stat } from "node:fs/promises";
import { createServer } from "node:http";
import path from "node:path";
import { pathToFileURL } from "node:url";

const policy = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' blob: data:";

const types = {
  ".css": "text/css; charset=utf-8",
  ".html": "text/html; charset=utf-8",
  ".ico": "image/x-icon",
  ".js": "text/javascript; charset=utf-8",
  ".json": "application/json; charset=utf-8",
  ".mjs": "text/javascript; charset=utf-8",
  ".otf": "font/otf",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".ttf": "font/ttf",
  ".txt": "text/plain; charset=utf-8",
  ".wasm": "application/wasm",
  ".webmanifest": "application/manifest+json",
  ".woff2": "font/woff2",
};

// Undefined for an unknown path, and outside the folder, whatever the path or a symbolic link contains.
async function find(root, url) {
  try {
    const name = decodeURIComponent(new URL(url, "http://localhost").pathname);
    let file = await realpath(path.join(root, name));
    if (file !== root && !file.startsWith(root + path.sep)) return undefined;
    if ((await stat(file)).isDirectory()) file = path.join(file, "index.html");
    const { size } = await stat(file);
    return { file, size };
  } catch {
    return undefined;
  }
}

async function answer(root, request, response) {
  response.setHeader("Content-Security-Policy", policy);
  response.setHeader("X-Content-Type-Options", "nosniff");
  response.setHeader("Cache-Control", "no-cache");
  if (request.method !== "GET" && request.method !== "HEAD") {
    response.writeHead(405, { Allow: "GET, HEAD" }).end();
    return;
  }
  const found = await find(root, request.url);
  if (!found) {
    response.writeHead(404, { "Content-Type": "text/plain" }).end("not found\n");
    return;
  }
  const type = types[path.extname(found.file)] ?? "application/octet-stream";
  response.writeHead(200, { "Content-Type": type, "Content-Length": found.size });
  if (request.method === "HEAD") {
    response.end();
    return;
  }
  createReadStream(found.file)
    .on("error", () => response.destroy())
    .pipe(response);
}

function listen(root, host, port) {
  const server = createServer((request, response) => answer(root, request, response));
  return new Promise((resolve, reject) => {
    server.once("error", reject);
    server.listen({ host, port }, () => resolve(server));
  });
}

// The browser chooses 127.0.0.1 or ::1 for `localhost`: both or neither are used, as far as this computer has them.
async function listenOnLocalhost(root, port) {
  const first = await listen(root, "127.0.0.1", port);
  try {
    const second = await listen(root, "::1", first.address().port);
    return [first, second];
  } catch (error) {
    if (error.code !== "EADDRINUSE") return [first];
    first.close();
    throw error;
  }
}

// Starts, and resolves to { url, close }. Port 0 means any free port.
export async function serve(folder, port = 8080) {
  const root = await realpath(folder);
  for (let tries = 0; ; ++tries) {
    try {
      const servers = await listenOnLocalhost(root, tries < 100 && port !== 0 ? port + tries : 0);
      return {
        url: `http://localhost:${servers[0].address().port}/`,
        close: () => {
          for (const server of servers) {
            server.close();
            server.closeAllConnections?.();
          }
        },
      };
    } catch (error) {
      if (error.code !== "EADDRINUSE" || tries >= 200) throw error;
    }
  }
}

async function main([folder, port = "8080", ...rest]) {
  if (!folder || rest.length > 0 || !/^\d{1,5}$/.test(port) || Number(port) > 65000) {
    console.error("usage: node web/serve.mjs FOLDER [PORT]");
    process.exitCode = 2;
    return;
  }
  let server;
  try {
    server = await serve(folder, Number(port));
  } catch (error) {
    console.error(`evenlift: ${error.message}`);
    process.exitCode = 1;
    return;
  }
  const { url, close } = server;
  const taken = port === "0" || url.endsWith(`:${port}/`) ? "" : ` (port ${port} is taken)`;
  console.log(`evenlift: the page is on ${url}${taken}`);
  console.log("evenlift: press Ctrl+C to stop");
  for (const signal of ["SIGINT", "SIGTERM", "SIGHUP"]) process.once(signal, close);
}

if (process.argv[1] && import.meta.url === pathToFileURL(await realpath(process.argv[1])).href) {
  await main(process.argv.slice(2));
}
