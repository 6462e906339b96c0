'use strict';
const kVersion = '{{version}}';
const kBytes = {{bytes}};  // of each file, uncompressed
{{start.js}}
{{files.js}}
{{input.js}}
addEventListener('DOMContentLoaded', begin);
