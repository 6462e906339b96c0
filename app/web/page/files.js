// Files: settings in the store of the browser; what is picked or dropped is opened; what is saved is
// a download.
const kHome = '/home/web_user/';
const kFiles = '/files/';
const kStored = 'spiraling-edge:';
/// The store, if this page has one: a sandboxed frame has none.
const store = (() => { try { return window.localStorage; } catch { return null; } })();

function filesUnder(FS, folder) {
  return FS.readdir(folder).filter(name => name !== '.' && name !== '..').flatMap(name => {
    const path = folder + name;
    return FS.isDir(FS.stat(path).mode) ? filesUnder(FS, path + '/') : [path];
  });
}

/// Writes a file of the program, and makes its folder.
function writeFile(path, bytes) {
  program.FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
  program.FS.writeFile(path, bytes);
}

/// Puts the kept settings where the program reads them, and the program's files into a folder.
function openStore({FS, ENV}) {
  ENV.HOME = kHome.slice(0, -1);
  FS.mkdir(kFiles.slice(0, -1));
  FS.chdir(kFiles.slice(0, -1));
  for (let i = 0; store && i < store.length; ++i) {
    const name = store.key(i);
    if (!name.startsWith(kStored)) continue;
    writeFile(kHome + name.slice(kStored.length), store.getItem(name));
  }
}

/// Keeps the settings for the next visit.
function keepSettings() {
  if (!store || !program || failedWith) return;
  guarded(() => program._webKeep());
  for (const path of filesUnder(program.FS, kHome)) {
    const name = kStored + path.slice(kHome.length);
    const text = program.FS.readFile(path, {encoding: 'utf8'});
    if (text !== store.getItem(name)) try { store.setItem(name, text); } catch { return; }
  }
}
/// What another tab has kept: the program merges its own into it.
addEventListener('storage', event => {
  if (program && event.key?.startsWith(kStored) && event.newValue !== null) writeFile(kHome + event.key.slice(kStored.length), event.newValue);
});
addEventListener('pagehide', keepSettings);

/// A file that the program writes outside of its settings goes to the downloads.
function saveAsDownloads({FS}) {
  const rename = FS.rename;
  FS.rename = (from, to) => {
    rename.call(FS, from, to);
    const path = FS.lookupPath(to).path;
    if (path.startsWith(kHome)) return;
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([FS.readFile(path)]));
    link.download = path.slice(path.lastIndexOf('/') + 1);
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  };
}

/// Opens files of the reader's machine: the first, as when it is dropped on the window.
async function openFiles(files) {
  if (!begun || files.length === 0) return;
  const paths = [];
  for (const file of files) {
    const path = kFiles + file.name.replace(/[\n/]/g, '_');
    try {
      writeFile(path, new Uint8Array(await file.arrayBuffer()));
    } catch (error) {
      return send('webSay', `${file.name} could not be read: a folder, or a file that is gone or too large for a browser.`);
    }
    paths.push(path);
  }
  send('webDropped', paths.join('\n'));
}

/// Puts the files that this page has inside where the program opens them.
async function unpackFiles() {
  for (const element of document.querySelectorAll('script[data-file]')) {
    writeFile(kFiles + element.dataset.file, new Uint8Array(await unpack(element)));
  }
}

/// Fetches the file that a link names by its address on the web. Throws a sentence.
async function fetchFileOf(link) {
  const address = link.includes('#') ? new URLSearchParams(link.slice(link.indexOf('#') + 1).replace(/\+/g, '%2B')).get('file') : null;
  if (!/^https?:/.test(address ?? '')) return;
  // The program opens the address as a path: it may lead nowhere else.
  const plain = URL.canParse?.(address) ?? true ? new URL(address).href : '';
  if (plain !== address || address.endsWith('/')) throw new Error(`${address} is no address of a file${plain && plain !== address ? `: did you mean ${plain}?` : '.'}`);
  const path = kFiles + address;
  if (program.FS.analyzePath(path).exists) return;
  const answer = await fetch(address, {credentials: 'omit', referrerPolicy: 'no-referrer'}).catch(() => null);
  if (!answer) throw new Error(`The file ${address} could not be fetched: there is no network, or its server does not let other pages read it (CORS). Download it, and drop it here.`);
  if (!answer.ok) throw new Error(`The file ${address} is not there (${answer.status}).`);
  writeFile(path, new Uint8Array(await answer.arrayBuffer()));
}
document.getElementById('picker').addEventListener('change', event => {
  openFiles([...event.target.files]);
  event.target.value = '';
});
addEventListener('dragover', event => event.preventDefault());
addEventListener('drop', event => {
  event.preventDefault();
  openFiles([...event.dataTransfer.files]);
});

/// Text that the program copies.
function copied(text) {
  if (navigator.clipboard) navigator.clipboard.writeText(text).catch(() => copyByHand(text));
  else copyByHand(text);
}
/// Where a page may not write the clipboard by itself, as in many frames: the text is shown, selected.
function copyByHand(text) {
  const sheet = document.getElementById('copy');
  const field = sheet.querySelector('textarea');
  field.value = text;
  sheet.showModal();
  field.select();
  if (document.execCommand('copy')) sheet.close();
}
document.getElementById('copy').addEventListener('close', () => canvas.focus({preventScroll: true}));
addEventListener('paste', event => {
  if (event.target !== typed) send('webPasted', event.clipboardData.getData('text'));
});
