"use strict";
const assert = require("node:assert");
const test = require("node:test");
const { Grammars } = require("./textmate");

const grammars = new Grammars();

/** Returns the innermost scopes of words, without the language at their end. */
function scopes(grammar, text, ...words) {
  const tokens = grammars.tokens(grammar, text);
  return words.map((word) => {
    const found = tokens.find((token) => text.slice(token.start, token.end) === word);
    assert.ok(found, `${word} in ${JSON.stringify(tokens.map((token) => text.slice(token.start, token.end)))}`);
    return (found.scopes[found.scopes.length - 1] || "").replace(/\.(mtl|ocl)$/, "");
  });
}

test("a template's declaration has names, modifiers and types", () => {
  assert.deepStrictEqual(
    scopes("text.mtl", "[template public t(c : Set(C)) overrides u]", "template", "public", "t", "Set", "overrides"),
    ["keyword.control", "storage.modifier", "entity.name.function", "entity.name.type", "storage.modifier"],
  );
});

test("what is between tags is nothing but text", () => {
  const text = "for if 'quoted' -- no comment\n[for (x | y)]it's[/for] if\n";
  const outside = grammars.tokens("text.mtl", text).filter((token) => token.scopes.length === 0);
  assert.deepStrictEqual(
    outside.map((token) => text.slice(token.start, token.end)),
    ["for if 'quoted' -- no comment\n", "it's", " if\n"],
  );
});

test("an expression may begin with the keyword of a block", () => {
  assert.deepStrictEqual(scopes("text.mtl", "[if a then 'b' else 'c' endif/]", "then", "endif"), [
    "keyword.control",
    "keyword.control",
  ]);
});

test("a bracket in quotes does not end a tag", () => {
  const text = "['['/]x[']'.size()/]y";
  const outside = grammars.tokens("text.mtl", text).filter((token) => token.scopes.length === 0);
  assert.deepStrictEqual(
    outside.map((token) => text.slice(token.start, token.end)),
    ["x", "y"],
  );
});

test("a feature with the name of a keyword is a feature, and an operation has parentheses", () => {
  assert.deepStrictEqual(scopes("source.ocl", "self.context->select(e | e.body)", "context", "select", "body", "self"), [
    "variable.other.property",
    "entity.name.function.member",
    "variable.other.property",
    "variable.language",
  ]);
});

test("what stands after a name and a colon is a type, but not after a constraint's", () => {
  const text = "def: f(x : a::B) : Integer = let y : C = x in y\n  inv Small: self.n < 1\n  inv: null";
  assert.deepStrictEqual(scopes("source.ocl", text, "a::B", "Integer", "C", "x", "self", "null"), [
    "entity.name.type",
    "entity.name.type",
    "entity.name.type",
    "variable.parameter",
    "variable.language",
    "constant.language",
  ]);
});

test("a constraint's class and name stand out", () => {
  assert.deepStrictEqual(
    scopes("source.ocl", "context a::B\n  inv IsSmall: self.n <= 1.5e2 -- or so", "a::B", "IsSmall", "1.5e2", "-- or so"),
    ["entity.name.type", "entity.name.function", "constant.numeric", "comment.line.double-dash"],
  );
});

test("what follows a string without an end is code again on the next line", () => {
  assert.deepStrictEqual(scopes("source.ocl", "x = 'open\nif true", "if", "true"), [
    "keyword.control",
    "constant.language",
  ]);
});
