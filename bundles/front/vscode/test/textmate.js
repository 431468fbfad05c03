"use strict";
// A small reader of TextMate grammars, for what these grammars use: so that tests need nothing but node. It follows
// the rules of VS Code's own: line by line, the leftmost match wins, of those at one place the end of a block, then the
// first pattern.

const fs = require("fs");
const path = require("path");

const FOLDER = path.join(__dirname, "..", "syntaxes");

class Grammars {
  constructor() {
    this.byScope = new Map();
    for (const name of fs.readdirSync(FOLDER)) {
      const grammar = JSON.parse(fs.readFileSync(path.join(FOLDER, name), "utf8"));
      this.byScope.set(grammar.scopeName, grammar);
    }
  }

  /** Returns the rules that a list of patterns stands for, each with the grammar that it is of. */
  rules(patterns, grammar) {
    return patterns.flatMap((rule) => {
      if (rule.include) {
        const [scope, name] = rule.include.split("#");
        const other = scope ? this.byScope.get(scope) : grammar;
        return this.rules(name ? [other.repository[name]] : other.patterns, other);
      }
      return rule.match || rule.begin ? [{ rule, grammar }] : this.rules(rule.patterns, grammar);
    });
  }

  /** Returns the pieces of a text as {start, end, scopes}, which cover it. */
  tokens(scope, text) {
    const grammar = this.byScope.get(scope);
    const state = { pieces: [], stack: [{ patterns: grammar.patterns, grammar, scopes: [] }] };
    let offset = 0;
    for (const line of text.split(/(?<=\n)/)) {
      this.line(line, offset, state);
      offset += line.length;
    }
    return state.pieces;
  }

  line(line, offset, state) {
    const add = (start, end, scopes) => end > start && state.pieces.push({ start: offset + start, end: offset + end, scopes });
    let position = 0;
    let last = "";
    while (position < line.length) {
      const top = state.stack[state.stack.length - 1];
      const best = this.best(line, position, top);
      if (!best) {
        break;
      }
      const { index } = best.found;
      const end = index + best.found[0].length;
      const where = `${state.stack.length} ${index} ${end} ${best.kind}`;
      if (end === position && where === last) {
        throw new Error(`A rule matches nothing, over and over, in ${JSON.stringify(line)}`);
      }
      last = where;
      add(position, index, top.scopes);
      const { rule } = best;
      const scopes = rule && rule.name ? [...top.scopes, rule.name] : top.scopes;
      if (best.kind === "end") {
        captured(best.found, top.rule.endCaptures, top.scopes, add);
        state.stack.pop();
      } else if (best.kind === "begin") {
        captured(best.found, rule.beginCaptures, scopes, add);
        state.stack.push({ patterns: rule.patterns || [], grammar: best.grammar, scopes, rule });
      } else {
        captured(best.found, rule.captures, scopes, add);
      }
      position = end;
    }
    add(position, line.length, state.stack[state.stack.length - 1].scopes);
  }

  best(line, position, top) {
    const candidates = this.rules(top.patterns, top.grammar).map(({ rule, grammar }) => ({
      rule,
      grammar,
      kind: rule.match ? "match" : "begin",
      found: search(rule.match || rule.begin, line, position),
    }));
    if (top.rule) {
      candidates.unshift({ kind: "end", found: search(top.rule.end, line, position) });
    }
    const found = candidates.filter((candidate) => candidate.found);
    return found.reduce((best, each) => (best && best.found.index <= each.found.index ? best : each), undefined);
  }
}

function search(pattern, line, position) {
  const expression = new RegExp(pattern, "dgm");
  expression.lastIndex = position;
  return expression.exec(line);
}

/** Adds the parts of a match: what a group names, inside the rest. */
function captured(found, captures, scopes, add) {
  const start = found.index;
  let position = start;
  const all = captures && captures[0] ? [...scopes, captures[0].name] : scopes;
  for (let i = 1; i < found.length; i++) {
    if (captures && captures[i] && found.indices[i]) {
      const [from, to] = found.indices[i];
      add(position, from, all);
      add(from, to, [...all, captures[i].name]);
      position = to;
    }
  }
  add(position, start + found[0].length, all);
}

module.exports = { Grammars };
