"use strict";
// node kinds.js FILE...: prints as JSON, for each template, where the grammar sees comments and tags, as [start, end, kind].

const fs = require("fs");
const { Grammars } = require("./textmate");

const grammars = new Grammars();

function kind(scopes) {
  const outer = scopes[0] || "";
  return outer.startsWith("comment") ? "COMMENT" : outer.startsWith("meta.tag") ? "TAG" : "TEXT";
}

function kinds(text) {
  const all = [];
  for (const { start, end, scopes } of grammars.tokens("text.mtl", text)) {
    const last = all[all.length - 1];
    if (last && last[2] === kind(scopes)) {
      last[1] = end;
    } else {
      all.push([start, end, kind(scopes)]);
    }
  }
  return all;
}

const result = {};
for (const file of process.argv.slice(2)) {
  result[file] = kinds(fs.readFileSync(file, "utf8"));
}
process.stdout.write(JSON.stringify(result));
