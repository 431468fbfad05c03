"use strict";
// Values of the language server protocol and of VS Code's own interface, one as the other.

const vscode = require("vscode");

/** @param {any} position */
const position = (position) => new vscode.Position(position.line, position.character);

/** @param {any} range */
const range = (range) => new vscode.Range(position(range.start), position(range.end));

/** @param {any} place */
const uri = (place) => vscode.Uri.parse(place, true);

/** @param {vscode.Position} position */
const asPosition = (position) => ({ line: position.line, character: position.character });

/** @param {vscode.Range} range */
const asRange = (range) => ({ start: asPosition(range.start), end: asPosition(range.end) });

/**
 * @param {any[] | null | undefined} items
 * @param {(item: any) => any} convert
 */
const all = (items, convert) => (items || []).map(convert);

/** @param {any} content a string, marked strings, or markup */
function markdown(content) {
  const text = new vscode.MarkdownString();
  for (const part of Array.isArray(content) ? content : [content]) {
    if (typeof part === "string" || part.kind === "markdown") {
      text.appendMarkdown(part.value === undefined ? part : part.value);
    } else if (part.kind === "plaintext") {
      text.appendText(part.value);
    } else {
      text.appendCodeblock(part.value, part.language);
    }
    text.appendMarkdown("\n\n");
  }
  return text;
}

/** @param {any} content of completions and signatures, where plain text stays plain */
const documentation = (content) =>
  content === undefined || content === null ? undefined : typeof content === "string" ? content : markdown(content);

/** @param {any} place */
const location = (place) => new vscode.Location(uri(place.uri), range(place.range));

/** @param {any} link */
const link = (link) => ({
  targetUri: uri(link.targetUri),
  targetRange: range(link.targetRange),
  targetSelectionRange: range(link.targetSelectionRange),
  originSelectionRange: link.originSelectionRange && range(link.originSelectionRange),
});

/** @param {any} places one, several or none */
const locations = (places) =>
  all(Array.isArray(places) ? places : places ? [places] : [], (place) => (place.targetUri ? link : location)(place));

/** @param {any} found */
function diagnostic(found) {
  const text = typeof found.message === "string" ? found.message : found.message.value;
  const shown = new vscode.Diagnostic(range(found.range), text, (found.severity || 1) - 1);
  shown.source = found.source;
  shown.code = found.codeDescription
    ? { value: found.code, target: vscode.Uri.parse(found.codeDescription.href) }
    : found.code;
  shown.tags = found.tags;
  shown.relatedInformation = all(
    found.relatedInformation,
    (related) => new vscode.DiagnosticRelatedInformation(location(related.location), related.message),
  );
  return shown;
}

/** @param {any} edit */
const textEdit = (edit) => new vscode.TextEdit(range(edit.range), edit.newText);

/** @param {any} edit of several files, which may also create, rename and delete some */
function workspaceEdit(edit) {
  const changes = new vscode.WorkspaceEdit();
  for (const change of edit.documentChanges || []) {
    const options = change.options || {};
    if (change.kind === "create") {
      changes.createFile(uri(change.uri), options);
    } else if (change.kind === "rename") {
      changes.renameFile(uri(change.oldUri), uri(change.newUri), options);
    } else if (change.kind === "delete") {
      changes.deleteFile(uri(change.uri), options);
    } else {
      changes.set(uri(change.textDocument.uri), all(change.edits, textEdit));
    }
  }
  for (const [file, edits] of edit.documentChanges ? [] : Object.entries(edit.changes || {})) {
    changes.set(uri(file), all(edits, textEdit));
  }
  return changes;
}

/** @param {any} command */
const command = (command) => ({ title: command.title, command: command.command, arguments: command.arguments });

/** @param {any} item */
function completion(item) {
  const label = item.labelDetails ? { label: item.label, ...item.labelDetails } : item.label;
  const proposal = new vscode.CompletionItem(label, item.kind === undefined ? undefined : item.kind - 1);
  const text = item.textEdit ? item.textEdit.newText : item.insertText === undefined ? item.label : item.insertText;
  proposal.insertText = item.insertTextFormat === 2 ? new vscode.SnippetString(text) : text;
  if (item.textEdit) {
    const { insert, replace } = item.textEdit;
    proposal.range = insert
      ? { inserting: range(insert), replacing: range(replace) }
      : range(item.textEdit.range);
  }
  proposal.detail = item.detail;
  proposal.documentation = documentation(item.documentation);
  proposal.sortText = item.sortText;
  proposal.filterText = item.filterText;
  proposal.preselect = item.preselect;
  proposal.tags = item.tags;
  proposal.commitCharacters = item.commitCharacters;
  proposal.additionalTextEdits = all(item.additionalTextEdits, textEdit);
  proposal.command = item.command && command(item.command);
  return Object.assign(proposal, { item });
}

/** @param {any} help */
function signatureHelp(help) {
  const shown = new vscode.SignatureHelp();
  shown.activeSignature = help.activeSignature || 0;
  shown.activeParameter = help.activeParameter || 0;
  shown.signatures = all(help.signatures, (signature) => {
    const each = new vscode.SignatureInformation(signature.label, documentation(signature.documentation));
    each.activeParameter = signature.activeParameter === null ? undefined : signature.activeParameter;
    each.parameters = all(
      signature.parameters,
      (parameter) => new vscode.ParameterInformation(parameter.label, documentation(parameter.documentation)),
    );
    return each;
  });
  return shown;
}

/**
 * @param {any} found in a document, with what is inside it, or with its place
 * @returns {any}
 */
function symbol(found) {
  if (found.location) {
    return new vscode.SymbolInformation(
      found.name,
      found.kind - 1,
      found.containerName || "",
      location(found.location),
    );
  }
  const shown = new vscode.DocumentSymbol(
    found.name,
    found.detail || "",
    found.kind - 1,
    range(found.range),
    range(found.selectionRange),
  );
  shown.children = all(found.children, symbol);
  return shown;
}

/** @param {any} hint */
function inlayHint(hint) {
  const label = Array.isArray(hint.label) ? hint.label.map((/** @type {any} */ part) => part.value).join("") : hint.label;
  const shown = new vscode.InlayHint(position(hint.position), label, hint.kind);
  shown.paddingLeft = hint.paddingLeft;
  shown.paddingRight = hint.paddingRight;
  shown.tooltip = documentation(hint.tooltip);
  return shown;
}

/**
 * @param {any} selection
 * @returns {vscode.SelectionRange}
 */
function selectionRange(selection) {
  const parent = selection.parent ? selectionRange(selection.parent) : undefined;
  return new vscode.SelectionRange(range(selection.range), parent);
}

/** @param {any} action a command, or an action with an edit and a command */
function codeAction(action) {
  if (typeof action.command === "string") {
    return command(action);
  }
  const kind = action.kind ? vscode.CodeActionKind.Empty.append(action.kind) : undefined;
  const shown = new vscode.CodeAction(action.title, kind);
  shown.diagnostics = action.diagnostics && all(action.diagnostics, diagnostic);
  shown.isPreferred = action.isPreferred;
  shown.disabled = action.disabled;
  shown.edit = action.edit && workspaceEdit(action.edit);
  shown.command = action.command && command(action.command);
  return Object.assign(shown, { item: action });
}

/** @param {any} item of a hierarchy of calls */
function hierarchyItem(item) {
  const shown = new vscode.CallHierarchyItem(
    item.kind - 1,
    item.name,
    item.detail || "",
    uri(item.uri),
    range(item.range),
    range(item.selectionRange),
  );
  return Object.assign(shown, { item });
}

module.exports = {
  all,
  asPosition,
  asRange,
  codeAction,
  command,
  completion,
  diagnostic,
  hierarchyItem,
  inlayHint,
  location,
  locations,
  markdown,
  position,
  range,
  selectionRange,
  signatureHelp,
  symbol,
  textEdit,
  uri,
  workspaceEdit,
};
