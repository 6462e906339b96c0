// A server of files, as any other: no header of its own but the type.
'use strict';
const fs = require('fs');
const http = require('http');
const path = require('path');

const kTypes = {'.html': 'text/html', '.css': 'text/css', '.js': 'text/javascript', '.wasm': 'application/wasm'};

/// Serves a folder at a free port; missing: names that it does not have; pages: their texts by path, with `headers`.
function serve(folder, {missing = [], pages = {}, headers = {}} = {}) {
  const server = http.createServer((request, answer) => {
    let name = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
    if (name in pages) return answer.writeHead(200, {'Content-Type': 'text/html', ...headers}).end(pages[name]);
    if (name.endsWith('/')) name += 'index.html';
    const file = path.join(folder, name);
    if (!file.startsWith(folder) || missing.includes(path.basename(name)) || !fs.existsSync(file) || fs.statSync(file).isDirectory())
      return answer.writeHead(404).end('not found');
    answer.writeHead(200, {'Content-Type': kTypes[path.extname(file)] ?? 'application/octet-stream'}).end(fs.readFileSync(file));
  });
  return new Promise(done => server.listen(0, '127.0.0.1', () => done({
    address: `http://localhost:${server.address().port}/`,
    stop: () => new Promise(stopped => { server.close(stopped); server.closeAllConnections(); }),
  })));
}

module.exports = {serve};
