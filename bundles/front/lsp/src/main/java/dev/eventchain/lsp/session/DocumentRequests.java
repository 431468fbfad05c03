package dev.eventchain.lsp.session;

import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.FileRange;
import dev.eventchain.editing.Rename;
import dev.eventchain.editing.RenameTarget;
import dev.eventchain.editing.TextPosition;
import dev.eventchain.editing.TextRange;
import dev.eventchain.lsp.action.FindingActions;
import dev.eventchain.lsp.language.CallItems;
import dev.eventchain.lsp.language.FileLinks;
import dev.eventchain.lsp.language.Formatting;
import dev.eventchain.lsp.language.Languages;
import dev.eventchain.lsp.language.Protocol;
import dev.eventchain.lsp.project.ProjectLenses;
import dev.eventchain.lsp.text.Edits;
import dev.eventchain.lsp.text.Positions;
import dev.eventchain.pipeline.Today;
import java.nio.file.Path;
import java.time.Clock;
import java.time.LocalDate;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.BiFunction;
import org.eclipse.lsp4j.CallHierarchyIncomingCall;
import org.eclipse.lsp4j.CallHierarchyIncomingCallsParams;
import org.eclipse.lsp4j.CallHierarchyItem;
import org.eclipse.lsp4j.CallHierarchyOutgoingCall;
import org.eclipse.lsp4j.CallHierarchyOutgoingCallsParams;
import org.eclipse.lsp4j.CallHierarchyPrepareParams;
import org.eclipse.lsp4j.CodeAction;
import org.eclipse.lsp4j.CodeActionParams;
import org.eclipse.lsp4j.CodeLens;
import org.eclipse.lsp4j.CodeLensParams;
import org.eclipse.lsp4j.Command;
import org.eclipse.lsp4j.CompletionItem;
import org.eclipse.lsp4j.CompletionList;
import org.eclipse.lsp4j.CompletionParams;
import org.eclipse.lsp4j.DefinitionParams;
import org.eclipse.lsp4j.DidChangeTextDocumentParams;
import org.eclipse.lsp4j.DidCloseTextDocumentParams;
import org.eclipse.lsp4j.DidOpenTextDocumentParams;
import org.eclipse.lsp4j.DidSaveTextDocumentParams;
import org.eclipse.lsp4j.DocumentFormattingParams;
import org.eclipse.lsp4j.DocumentHighlight;
import org.eclipse.lsp4j.DocumentHighlightParams;
import org.eclipse.lsp4j.DocumentLink;
import org.eclipse.lsp4j.DocumentLinkParams;
import org.eclipse.lsp4j.DocumentRangeFormattingParams;
import org.eclipse.lsp4j.DocumentSymbol;
import org.eclipse.lsp4j.DocumentSymbolParams;
import org.eclipse.lsp4j.FoldingRange;
import org.eclipse.lsp4j.FoldingRangeRequestParams;
import org.eclipse.lsp4j.Hover;
import org.eclipse.lsp4j.HoverParams;
import org.eclipse.lsp4j.ImplementationParams;
import org.eclipse.lsp4j.InlayHint;
import org.eclipse.lsp4j.InlayHintParams;
import org.eclipse.lsp4j.Location;
import org.eclipse.lsp4j.LocationLink;
import org.eclipse.lsp4j.PrepareRenameDefaultBehavior;
import org.eclipse.lsp4j.PrepareRenameParams;
import org.eclipse.lsp4j.PrepareRenameResult;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.ReferenceParams;
import org.eclipse.lsp4j.RenameParams;
import org.eclipse.lsp4j.SelectionRange;
import org.eclipse.lsp4j.SelectionRangeParams;
import org.eclipse.lsp4j.SemanticTokens;
import org.eclipse.lsp4j.SemanticTokensParams;
import org.eclipse.lsp4j.SignatureHelp;
import org.eclipse.lsp4j.SignatureHelpParams;
import org.eclipse.lsp4j.SymbolInformation;
import org.eclipse.lsp4j.TextDocumentPositionParams;
import org.eclipse.lsp4j.TextEdit;
import org.eclipse.lsp4j.TypeDefinitionParams;
import org.eclipse.lsp4j.WorkspaceEdit;
import org.eclipse.lsp4j.jsonrpc.ResponseErrorException;
import org.eclipse.lsp4j.jsonrpc.messages.Either;
import org.eclipse.lsp4j.jsonrpc.messages.Either3;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseError;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseErrorCode;
import org.eclipse.lsp4j.services.TextDocumentService;

/**
 * Requests and notifications of an editor about texts. Texts that are no files on this machine are
 * ignored.
 */
final class DocumentRequests implements TextDocumentService {

  private final TextChanges changes;
  private final Languages languages;
  private final Edits edits;
  private final CallItems calls;
  private final FindingActions actions;
  private final ProjectLenses lenses;
  private final FileLinks links;
  private final Formatting formatting;

  DocumentRequests(
      TextChanges changes,
      Languages languages,
      Edits edits,
      FindingActions actions,
      ProjectLenses lenses,
      FileLinks links,
      Formatting formatting) {
    this.lenses = lenses;
    this.links = links;
    this.formatting = formatting;
    this.changes = changes;
    this.languages = languages;
    this.edits = edits;
    this.calls = new CallItems(languages, edits);
    this.actions = actions;
  }

  @Override
  public void didOpen(DidOpenTextDocumentParams params) {
    changes.opened(params.getTextDocument());
  }

  @Override
  public void didChange(DidChangeTextDocumentParams params) {
    changes.changed(params);
  }

  @Override
  public void didClose(DidCloseTextDocumentParams params) {
    changes.closed(params.getTextDocument().getUri());
  }

  /** Does nothing: the text is known from its changes, and a new file is noticed on disk. */
  @Override
  public void didSave(DidSaveTextDocumentParams params) {}

  @Override
  public CompletableFuture<List<Either<SymbolInformation, DocumentSymbol>>> documentSymbol(
      DocumentSymbolParams params) {
    return languages.ask(
        params.getTextDocument().getUri(),
        List.of(),
        analysis ->
            analysis.symbols().stream()
                .map(Protocol::symbol)
                .map(Either::<SymbolInformation, DocumentSymbol>forRight)
                .toList());
  }

  @Override
  public CompletableFuture<List<FoldingRange>> foldingRange(FoldingRangeRequestParams params) {
    return languages.ask(
        params.getTextDocument().getUri(),
        List.of(),
        analysis -> analysis.foldings().stream().map(Protocol::folding).toList());
  }

  @Override
  public CompletableFuture<SemanticTokens> semanticTokensFull(SemanticTokensParams params) {
    return languages.ask(
        params.getTextDocument().getUri(),
        new SemanticTokens(List.of()),
        analysis -> new SemanticTokens(Protocol.tokens(analysis.tokens())));
  }

  @Override
  public CompletableFuture<Either<List<CompletionItem>, CompletionList>> completion(
      CompletionParams params) {
    return at(
        params,
        Either.forLeft(List.of()),
        (analysis, position) ->
            Either.forLeft(Protocol.completions(analysis.completions(position))));
  }

  @Override
  public CompletableFuture<Hover> hover(HoverParams params) {
    return at(
        params,
        null,
        (analysis, position) ->
            analysis
                .hover(position)
                .map(it -> new Hover(Protocol.markdown(it.markdown()), Positions.of(it.range())))
                .orElse(null));
  }

  @Override
  public CompletableFuture<SignatureHelp> signatureHelp(SignatureHelpParams params) {
    return at(
        params,
        null,
        (analysis, position) ->
            analysis.signatureHelp(position).map(Protocol::signatures).orElse(null));
  }

  @Override
  public CompletableFuture<Either<List<? extends Location>, List<? extends LocationLink>>>
      definition(DefinitionParams params) {
    return places(params, Analysis::definitions);
  }

  @Override
  public CompletableFuture<Either<List<? extends Location>, List<? extends LocationLink>>>
      typeDefinition(TypeDefinitionParams params) {
    return places(params, Analysis::typeDefinitions);
  }

  @Override
  public CompletableFuture<Either<List<? extends Location>, List<? extends LocationLink>>>
      implementation(ImplementationParams params) {
    return places(params, Analysis::implementations);
  }

  private CompletableFuture<Either<List<? extends Location>, List<? extends LocationLink>>> places(
      TextDocumentPositionParams params,
      BiFunction<Analysis, TextPosition, List<FileRange>> question) {
    return at(
        params,
        Either.forLeft(List.of()),
        (analysis, position) ->
            Either.forLeft(edits.locations(question.apply(analysis, position))));
  }

  @Override
  public CompletableFuture<List<? extends Location>> references(ReferenceParams params) {
    boolean declaration = params.getContext().isIncludeDeclaration();
    return at(
        params,
        List.of(),
        (analysis, position) -> edits.locations(analysis.references(position, declaration)));
  }

  @Override
  public CompletableFuture<List<? extends DocumentHighlight>> documentHighlight(
      DocumentHighlightParams params) {
    Optional<Path> file = Positions.path(params.getTextDocument().getUri());
    return at(
        params,
        List.of(),
        (analysis, position) ->
            analysis.references(position, true).stream()
                .filter(each -> file.equals(Optional.of(each.file())))
                .map(each -> new DocumentHighlight(edits.range(each.file(), each.range())))
                .toList());
  }

  @Override
  public CompletableFuture<Either3<Range, PrepareRenameResult, PrepareRenameDefaultBehavior>>
      prepareRename(PrepareRenameParams params) {
    return at(
        params,
        null,
        (analysis, position) -> {
          RenameTarget target = analysis.renameTarget(position);
          if (!target.isAllowed()) {
            throw refused(target.refusal());
          }
          return Either3.forSecond(
              new PrepareRenameResult(Positions.of(target.range()), target.name()));
        });
  }

  @Override
  public CompletableFuture<WorkspaceEdit> rename(RenameParams params) {
    return at(
        params,
        null,
        (analysis, position) -> {
          Rename rename = analysis.rename(position, params.getNewName());
          if (!rename.isAllowed()) {
            throw refused(rename.refusal());
          }
          return edits.of(rename.edits());
        });
  }

  private static ResponseErrorException refused(String reason) {
    return new ResponseErrorException(
        new ResponseError(ResponseErrorCode.RequestFailed, reason, null));
  }

  @Override
  public CompletableFuture<List<SelectionRange>> selectionRange(SelectionRangeParams params) {
    List<TextPosition> positions = params.getPositions().stream().map(Positions::of).toList();
    return languages.ask(
        params.getTextDocument().getUri(),
        List.of(),
        analysis ->
            positions.stream()
                .map(each -> Protocol.selection(analysis.selectionRanges(each), TextRange.at(each)))
                .toList());
  }

  @Override
  public CompletableFuture<List<InlayHint>> inlayHint(InlayHintParams params) {
    TextRange range = Positions.of(params.getRange());
    return languages.ask(
        params.getTextDocument().getUri(),
        List.of(),
        analysis ->
            analysis.inlayHints(range).stream()
                .map(
                    each ->
                        new InlayHint(Positions.of(each.position()), Either.forLeft(each.text())))
                .toList());
  }

  @Override
  public CompletableFuture<List<Either<Command, CodeAction>>> codeAction(CodeActionParams params) {
    LocalDate today = Today.of(System.getenv(), Clock.systemUTC()).date();
    return languages.later(
        () ->
            Positions.path(params.getTextDocument().getUri())
                .map(file -> actions.of(file, params.getRange(), today))
                .orElse(List.of())
                .stream()
                .map(Either::<Command, CodeAction>forRight)
                .toList());
  }

  @Override
  public CompletableFuture<List<? extends CodeLens>> codeLens(CodeLensParams params) {
    return languages.later(
        () -> Positions.path(params.getTextDocument().getUri()).map(lenses::of).orElse(List.of()));
  }

  @Override
  public CompletableFuture<List<DocumentLink>> documentLink(DocumentLinkParams params) {
    return languages.later(
        () -> Positions.path(params.getTextDocument().getUri()).map(links::of).orElse(List.of()));
  }

  @Override
  public CompletableFuture<List<? extends TextEdit>> formatting(DocumentFormattingParams params) {
    return languages.later(
        () -> formatting.of(params.getTextDocument().getUri(), params.getOptions(), line -> true));
  }

  @Override
  public CompletableFuture<List<? extends TextEdit>> rangeFormatting(
      DocumentRangeFormattingParams params) {
    return languages.later(
        () ->
            formatting.of(
                params.getTextDocument().getUri(),
                params.getOptions(),
                Positions.lines(params.getRange())));
  }

  @Override
  public CompletableFuture<List<CallHierarchyItem>> prepareCallHierarchy(
      CallHierarchyPrepareParams params) {
    return at(
        params,
        List.of(),
        (analysis, position) -> analysis.callItems(position).stream().map(calls::of).toList());
  }

  @Override
  public CompletableFuture<List<CallHierarchyIncomingCall>> callHierarchyIncomingCalls(
      CallHierarchyIncomingCallsParams params) {
    return languages.later(() -> calls.incoming(params.getItem()));
  }

  @Override
  public CompletableFuture<List<CallHierarchyOutgoingCall>> callHierarchyOutgoingCalls(
      CallHierarchyOutgoingCallsParams params) {
    return languages.later(() -> calls.outgoing(params.getItem()));
  }

  private <T> CompletableFuture<T> at(
      TextDocumentPositionParams params,
      T nothing,
      BiFunction<Analysis, TextPosition, T> question) {
    return languages.ask(
        params.getTextDocument().getUri(), params.getPosition(), nothing, question);
  }
}
