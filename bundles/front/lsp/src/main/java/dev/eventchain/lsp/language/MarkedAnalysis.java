package dev.eventchain.lsp.language;

import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.Call;
import dev.eventchain.editing.Completion;
import dev.eventchain.editing.FileRange;
import dev.eventchain.editing.Folding;
import dev.eventchain.editing.Hover;
import dev.eventchain.editing.InlayHint;
import dev.eventchain.editing.Rename;
import dev.eventchain.editing.RenameTarget;
import dev.eventchain.editing.SemanticToken;
import dev.eventchain.editing.SignatureHelp;
import dev.eventchain.editing.Symbol;
import dev.eventchain.editing.TextPosition;
import dev.eventchain.editing.TextRange;
import dev.eventchain.lsp.text.Positions;
import java.util.List;
import java.util.Optional;

/**
 * Answers about a text whose editor has kept its byte order mark, which counts as the first column.
 * Places in files, and what can be called there, stay as they are: who sends them converts them for
 * each file.
 */
record MarkedAnalysis(Analysis analysis) implements Analysis {

  private static final int MARK = 1;

  private static TextPosition inside(TextPosition position) {
    return Positions.shifted(position, -MARK);
  }

  private static TextRange shown(TextRange range) {
    return Positions.shifted(range, MARK);
  }

  @Override
  public List<Symbol> symbols() {
    return analysis.symbols().stream().map(MarkedAnalysis::shown).toList();
  }

  @Override
  public List<Symbol> workspaceSymbols() {
    return analysis.workspaceSymbols().stream().map(MarkedAnalysis::shown).toList();
  }

  private static Symbol shown(Symbol symbol) {
    return new Symbol(
        symbol.name(),
        symbol.detail(),
        symbol.kind(),
        shown(symbol.range()),
        shown(symbol.nameRange()),
        symbol.children().stream().map(MarkedAnalysis::shown).toList());
  }

  @Override
  public List<Folding> foldings() {
    return analysis.foldings();
  }

  @Override
  public List<SemanticToken> tokens() {
    return analysis.tokens().stream()
        .map(
            each ->
                new SemanticToken(
                    each.line(),
                    each.line() == 0 ? each.column() + MARK : each.column(),
                    each.length(),
                    each.kind(),
                    each.declaration()))
        .toList();
  }

  @Override
  public List<Completion> completions(TextPosition position) {
    return analysis.completions(inside(position)).stream()
        .map(
            each ->
                new Completion(
                    each.label(),
                    each.kind(),
                    each.detail(),
                    each.documentation(),
                    each.insertText(),
                    each.snippet(),
                    shown(each.replaced())))
        .toList();
  }

  @Override
  public Optional<Hover> hover(TextPosition position) {
    return analysis
        .hover(inside(position))
        .map(each -> new Hover(each.markdown(), shown(each.range())));
  }

  @Override
  public Optional<SignatureHelp> signatureHelp(TextPosition position) {
    return analysis.signatureHelp(inside(position));
  }

  @Override
  public List<FileRange> definitions(TextPosition position) {
    return analysis.definitions(inside(position));
  }

  @Override
  public List<FileRange> typeDefinitions(TextPosition position) {
    return analysis.typeDefinitions(inside(position));
  }

  @Override
  public List<FileRange> implementations(TextPosition position) {
    return analysis.implementations(inside(position));
  }

  @Override
  public List<FileRange> references(TextPosition position, boolean declaration) {
    return analysis.references(inside(position), declaration);
  }

  @Override
  public RenameTarget renameTarget(TextPosition position) {
    RenameTarget target = analysis.renameTarget(inside(position));
    return target.isAllowed() ? RenameTarget.of(shown(target.range()), target.name()) : target;
  }

  @Override
  public Rename rename(TextPosition position, String newName) {
    return analysis.rename(inside(position), newName);
  }

  @Override
  public List<TextRange> selectionRanges(TextPosition position) {
    return analysis.selectionRanges(inside(position)).stream().map(MarkedAnalysis::shown).toList();
  }

  @Override
  public List<InlayHint> inlayHints(TextRange range) {
    return analysis.inlayHints(new TextRange(inside(range.start()), inside(range.end()))).stream()
        .map(each -> new InlayHint(Positions.shifted(each.position(), MARK), each.text()))
        .toList();
  }

  @Override
  public List<Call.Item> callItems(TextPosition position) {
    return analysis.callItems(inside(position));
  }
}
