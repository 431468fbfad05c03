"use strict";
// What the editor asks, asked of the server: one provider for each capability that the server declares.

const vscode = require("vscode");
const convert = require("./convert");
const { SELECTOR } = require("../files");

const { all, asPosition, asRange, range } = convert;

/** What this client can do with answers. */
const CAPABILITIES = {
  completion: {
    completionItem: {
      snippetSupport: true,
      commitCharactersSupport: true,
      documentationFormat: ["markdown", "plaintext"],
      preselectSupport: true,
      insertReplaceSupport: true,
      labelDetailsSupport: true,
      resolveSupport: { properties: ["documentation", "detail", "additionalTextEdits"] },
    },
    contextSupport: true,
  },
  hover: { contentFormat: ["markdown", "plaintext"] },
  signatureHelp: {
    signatureInformation: {
      documentationFormat: ["markdown", "plaintext"],
      parameterInformation: { labelOffsetSupport: true },
      activeParameterSupport: true,
    },
    contextSupport: true,
  },
  declaration: { linkSupport: true },
  definition: { linkSupport: true },
  typeDefinition: { linkSupport: true },
  implementation: { linkSupport: true },
  references: {},
  documentHighlight: {},
  documentSymbol: { hierarchicalDocumentSymbolSupport: true },
  codeAction: {
    codeActionLiteralSupport: { codeActionKind: { valueSet: ["", "quickfix", "refactor", "source"] } },
    isPreferredSupport: true,
    disabledSupport: true,
    dataSupport: true,
    resolveSupport: { properties: ["edit", "command"] },
  },
  codeLens: {},
  documentLink: { tooltipSupport: true },
  formatting: {},
  rangeFormatting: {},
  rename: { prepareSupport: true },
  foldingRange: { lineFoldingOnly: true },
  selectionRange: {},
  callHierarchy: {},
  inlayHint: {},
  semanticTokens: {
    requests: { range: true, full: true },
    tokenTypes: [
      "namespace", "type", "class", "enum", "interface", "struct", "typeParameter", "parameter", "variable", "property",
      "enumMember", "event", "function", "method", "macro", "keyword", "modifier", "comment", "string", "number",
      "regexp", "operator", "decorator",
    ],
    tokenModifiers: [
      "declaration", "definition", "readonly", "static", "deprecated", "abstract", "async", "modification",
      "documentation", "defaultLibrary",
    ],
    formats: ["relative"],
  },
};

/**
 * @callback Ask
 * @param {string} method
 * @param {any} params
 * @param {vscode.CancellationToken} [token]
 * @returns {Promise<any>} null if there is no answer
 */

/** @param {vscode.TextDocument} document */
const of = (document) => ({ textDocument: { uri: document.uri.toString() } });

/**
 * @param {vscode.TextDocument} document
 * @param {vscode.Position} position
 */
const at = (document, position) => ({ ...of(document), position: asPosition(position) });

/** Registers what a server can do; its capability may be true, or hold options. */
class Features {
  /**
   * @param {any} capabilities of the server
   * @param {Ask} ask
   */
  constructor(capabilities, ask) {
    this.capabilities = capabilities;
    this.ask = ask;
    /** @type {vscode.Disposable[]} */
    this.registered = [];
    this.lensesChanged = new vscode.EventEmitter();
    this.hintsChanged = new vscode.EventEmitter();
    this.tokensChanged = new vscode.EventEmitter();
  }

  /**
   * @param {string} capability
   * @param {(options: any) => vscode.Disposable} register
   */
  where(capability, register) {
    const declared = this.capabilities[capability];
    if (declared) {
      this.registered.push(register(declared === true ? {} : declared));
    }
  }

  register() {
    this.completion();
    this.navigation();
    this.symbols();
    this.changes();
    this.annotations();
    this.structure();
    return vscode.Disposable.from(...this.registered, this.lensesChanged, this.hintsChanged, this.tokensChanged);
  }

  completion() {
    const { ask } = this;
    this.where("completionProvider", (options) =>
      vscode.languages.registerCompletionItemProvider(
        SELECTOR,
        {
          async provideCompletionItems(document, position, token, context) {
            const reason = { triggerKind: context.triggerKind + 1, triggerCharacter: context.triggerCharacter };
            const found = await ask("textDocument/completion", { ...at(document, position), context: reason }, token);
            const items = Array.isArray(found) ? found : found ? found.items : [];
            return new vscode.CompletionList(all(items, convert.completion), found ? found.isIncomplete : false);
          },
          async resolveCompletionItem(proposal, token) {
            const item = /** @type {any} */ (proposal).item;
            const whole = options.resolveProvider && (await ask("completionItem/resolve", item, token));
            return whole ? Object.assign(proposal, { ...convert.completion(whole), range: proposal.range }) : proposal;
          },
        },
        ...(options.triggerCharacters || []),
      ),
    );
    this.where("hoverProvider", () =>
      vscode.languages.registerHoverProvider(SELECTOR, {
        async provideHover(document, position, token) {
          const found = await ask("textDocument/hover", at(document, position), token);
          return found && new vscode.Hover(convert.markdown(found.contents), found.range && range(found.range));
        },
      }),
    );
    this.where("signatureHelpProvider", (options) =>
      vscode.languages.registerSignatureHelpProvider(
        SELECTOR,
        {
          async provideSignatureHelp(document, position, token) {
            const found = await ask("textDocument/signatureHelp", at(document, position), token);
            return found && convert.signatureHelp(found);
          },
        },
        {
          triggerCharacters: options.triggerCharacters || [],
          retriggerCharacters: options.retriggerCharacters || [],
        },
      ),
    );
  }

  navigation() {
    const { ask } = this;
    /** @type {[string, (provide: any) => vscode.Disposable][]} */
    const kinds = [
      ["declaration", (f) => vscode.languages.registerDeclarationProvider(SELECTOR, { provideDeclaration: f })],
      ["definition", (f) => vscode.languages.registerDefinitionProvider(SELECTOR, { provideDefinition: f })],
      ["typeDefinition", (f) => vscode.languages.registerTypeDefinitionProvider(SELECTOR, { provideTypeDefinition: f })],
      ["implementation", (f) => vscode.languages.registerImplementationProvider(SELECTOR, { provideImplementation: f })],
    ];
    for (const [kind, register] of kinds) {
      this.where(`${kind}Provider`, () =>
        register(
          async (
            /** @type {vscode.TextDocument} */ document,
            /** @type {vscode.Position} */ position,
            /** @type {vscode.CancellationToken} */ token,
          ) => convert.locations(await ask(`textDocument/${kind}`, at(document, position), token)),
        ),
      );
    }
    this.where("referencesProvider", () =>
      vscode.languages.registerReferenceProvider(SELECTOR, {
        async provideReferences(document, position, context, token) {
          const params = { ...at(document, position), context };
          return convert.locations(await ask("textDocument/references", params, token));
        },
      }),
    );
    this.where("documentHighlightProvider", () =>
      vscode.languages.registerDocumentHighlightProvider(SELECTOR, {
        async provideDocumentHighlights(document, position, token) {
          const found = await ask("textDocument/documentHighlight", at(document, position), token);
          return all(found, (each) => new vscode.DocumentHighlight(range(each.range), (each.kind || 1) - 1));
        },
      }),
    );
    this.where("documentLinkProvider", (options) =>
      vscode.languages.registerDocumentLinkProvider(SELECTOR, {
        async provideDocumentLinks(document, token) {
          return all(await ask("textDocument/documentLink", of(document), token), (link) => {
            const shown = new vscode.DocumentLink(range(link.range), link.target && convert.uri(link.target));
            shown.tooltip = link.tooltip;
            return Object.assign(shown, { item: link });
          });
        },
        async resolveDocumentLink(link, token) {
          const item = /** @type {any} */ (link).item;
          const whole = options.resolveProvider && (await ask("documentLink/resolve", item, token));
          link.target = whole && whole.target ? convert.uri(whole.target) : link.target;
          return link;
        },
      }),
    );
    this.where("callHierarchyProvider", () => this.callHierarchy());
  }

  callHierarchy() {
    const { ask } = this;
    const item = (/** @type {any} */ shown) => ({ item: shown.item });
    return vscode.languages.registerCallHierarchyProvider(SELECTOR, {
      async prepareCallHierarchy(document, position, token) {
        const found = await ask("textDocument/prepareCallHierarchy", at(document, position), token);
        return all(found, convert.hierarchyItem);
      },
      async provideCallHierarchyIncomingCalls(called, token) {
        return all(
          await ask("callHierarchy/incomingCalls", item(called), token),
          (call) => new vscode.CallHierarchyIncomingCall(convert.hierarchyItem(call.from), all(call.fromRanges, range)),
        );
      },
      async provideCallHierarchyOutgoingCalls(calling, token) {
        return all(
          await ask("callHierarchy/outgoingCalls", item(calling), token),
          (call) => new vscode.CallHierarchyOutgoingCall(convert.hierarchyItem(call.to), all(call.fromRanges, range)),
        );
      },
    });
  }

  symbols() {
    const { ask } = this;
    this.where("documentSymbolProvider", () =>
      vscode.languages.registerDocumentSymbolProvider(SELECTOR, {
        async provideDocumentSymbols(document, token) {
          return all(await ask("textDocument/documentSymbol", of(document), token), convert.symbol);
        },
      }),
    );
    this.where("workspaceSymbolProvider", () =>
      vscode.languages.registerWorkspaceSymbolProvider({
        async provideWorkspaceSymbols(query, token) {
          return all(await ask("workspace/symbol", { query }, token), convert.symbol);
        },
      }),
    );
  }

  changes() {
    const { ask } = this;
    this.where("renameProvider", (options) =>
      vscode.languages.registerRenameProvider(SELECTOR, {
        async provideRenameEdits(document, position, newName, token) {
          const edit = await ask("textDocument/rename", { ...at(document, position), newName }, token);
          return edit && convert.workspaceEdit(edit);
        },
        prepareRename: options.prepareProvider
          ? async (document, position, token) => {
              const found = await ask("textDocument/prepareRename", at(document, position), token);
              if (!found) {
                throw new Error("There is nothing here that can be renamed.");
              }
              const place = found.start ? found : found.range;
              return !place
                ? document.getWordRangeAtPosition(position)
                : found.placeholder
                  ? { range: range(place), placeholder: found.placeholder }
                  : range(place);
            }
          : undefined,
      }),
    );
    this.where("codeActionProvider", (options) =>
      vscode.languages.registerCodeActionsProvider(
        SELECTOR,
        {
          async provideCodeActions(document, place, context, token) {
            const diagnostics = context.diagnostics.map((shown) => /** @type {any} */ (shown).item).filter(Boolean);
            const only = context.only ? [context.only.value] : undefined;
            const params = { ...of(document), range: asRange(place), context: { diagnostics, only } };
            return all(await ask("textDocument/codeAction", params, token), convert.codeAction);
          },
          async resolveCodeAction(action, token) {
            const item = /** @type {any} */ (action).item;
            const whole = options.resolveProvider && (await ask("codeAction/resolve", item, token));
            return whole ? Object.assign(action, convert.codeAction(whole)) : action;
          },
        },
        // An empty list would say that there are none of any kind.
        options.codeActionKinds && {
          providedCodeActionKinds: all(options.codeActionKinds, (kind) => vscode.CodeActionKind.Empty.append(kind)),
        },
      ),
    );
    const asOptions = (/** @type {vscode.FormattingOptions} */ options) => ({ ...options });
    this.where("documentFormattingProvider", () =>
      vscode.languages.registerDocumentFormattingEditProvider(SELECTOR, {
        async provideDocumentFormattingEdits(document, options, token) {
          const params = { ...of(document), options: asOptions(options) };
          return all(await ask("textDocument/formatting", params, token), convert.textEdit);
        },
      }),
    );
    this.where("documentRangeFormattingProvider", () =>
      vscode.languages.registerDocumentRangeFormattingEditProvider(SELECTOR, {
        async provideDocumentRangeFormattingEdits(document, place, options, token) {
          const params = { ...of(document), range: asRange(place), options: asOptions(options) };
          return all(await ask("textDocument/rangeFormatting", params, token), convert.textEdit);
        },
      }),
    );
  }

  annotations() {
    const { ask, lensesChanged, hintsChanged, tokensChanged } = this;
    this.where("codeLensProvider", (options) =>
      vscode.languages.registerCodeLensProvider(SELECTOR, {
        onDidChangeCodeLenses: lensesChanged.event,
        async provideCodeLenses(document, token) {
          return all(await ask("textDocument/codeLens", of(document), token), (lens) =>
            Object.assign(new vscode.CodeLens(range(lens.range), lens.command && convert.command(lens.command)), {
              item: lens,
            }),
          );
        },
        async resolveCodeLens(lens, token) {
          const item = /** @type {any} */ (lens).item;
          const whole = options.resolveProvider && (await ask("codeLens/resolve", item, token));
          lens.command = whole && whole.command ? convert.command(whole.command) : lens.command;
          return lens;
        },
      }),
    );
    this.where("inlayHintProvider", () =>
      vscode.languages.registerInlayHintsProvider(SELECTOR, {
        onDidChangeInlayHints: hintsChanged.event,
        async provideInlayHints(document, place, token) {
          const params = { ...of(document), range: asRange(place) };
          return all(await ask("textDocument/inlayHint", params, token), convert.inlayHint);
        },
      }),
    );
    this.where("semanticTokensProvider", ({ legend, full }) => {
      const names = new vscode.SemanticTokensLegend(legend.tokenTypes, legend.tokenModifiers);
      const method = full ? "textDocument/semanticTokens/full" : "textDocument/semanticTokens/range";
      const tokens = async (/** @type {any} */ params, /** @type {vscode.CancellationToken} */ token) => {
        const found = await ask(method, params, token);
        return found && new vscode.SemanticTokens(new Uint32Array(found.data), found.resultId);
      };
      return full
        ? vscode.languages.registerDocumentSemanticTokensProvider(
            SELECTOR,
            {
              onDidChangeSemanticTokens: tokensChanged.event,
              provideDocumentSemanticTokens: (document, token) => tokens(of(document), token),
            },
            names,
          )
        : vscode.languages.registerDocumentRangeSemanticTokensProvider(
            SELECTOR,
            {
              provideDocumentRangeSemanticTokens: (document, place, token) =>
                tokens({ ...of(document), range: asRange(place) }, token),
            },
            names,
          );
    });
  }

  structure() {
    const { ask } = this;
    this.where("foldingRangeProvider", () =>
      vscode.languages.registerFoldingRangeProvider(SELECTOR, {
        async provideFoldingRanges(document, context, token) {
          const kinds = { comment: 1, imports: 2, region: 3 };
          return all(
            await ask("textDocument/foldingRange", of(document), token),
            (fold) =>
              new vscode.FoldingRange(fold.startLine, fold.endLine, kinds[/** @type {"comment"} */ (fold.kind)]),
          );
        },
      }),
    );
    this.where("selectionRangeProvider", () =>
      vscode.languages.registerSelectionRangeProvider(SELECTOR, {
        async provideSelectionRanges(document, positions, token) {
          const params = { ...of(document), positions: positions.map(asPosition) };
          return all(await ask("textDocument/selectionRange", params, token), convert.selectionRange);
        },
      }),
    );
  }
}

module.exports = { CAPABILITIES, Features };
