package dev.eventchain.editing;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The answers of a language service as lines of text. */
public final class Answers {

  private final LanguageService service;
  private final Path file;
  private final TextPosition position;

  private Answers(LanguageService service, Path file, TextPosition position) {
    this.service = service;
    this.file = file;
    this.position = position;
  }

  /**
   * Returns the answer to a question.
   *
   * @param question the name of a method of {@link Analysis}, such as {@code hover}; {@code rename
   *     NAME}; {@code incomingCalls} or {@code outgoingCalls}
   * @throws IllegalArgumentException if there is no such question
   */
  public static List<String> to(
      String question, LanguageService service, Path file, TextPosition position) {
    Optional<Analysis> analysis = service.analysis(file);
    return analysis.isEmpty()
        ? List.of()
        : new Answers(service, file, position).answer(question, analysis.get());
  }

  private List<String> answer(String question, Analysis analysis) {
    if (question.startsWith("rename ")) {
      Rename rename = analysis.rename(position, question.substring("rename ".length()));
      return rename.isAllowed()
          ? rename.edits().stream().map(each -> place(each.file(), each.range())).toList()
          : List.of("refused: " + rename.refusal());
    }
    return switch (question) {
      case "symbols" -> symbols(analysis.symbols(), "");
      case "foldings" -> analysis.foldings().stream().map(Answers::text).toList();
      case "tokens" -> analysis.tokens().stream().map(Answers::text).toList();
      case "completions" -> analysis.completions(position).stream().map(Answers::text).toList();
      case "hover" -> analysis.hover(position).stream().flatMap(e -> e.markdown().lines()).toList();
      case "signatureHelp" -> analysis.signatureHelp(position).map(Answers::text).orElse(List.of());
      case "definitions" -> places(analysis.definitions(position));
      case "typeDefinitions" -> places(analysis.typeDefinitions(position));
      case "implementations" -> places(analysis.implementations(position));
      case "references" -> places(analysis.references(position, true));
      case "renameTarget" -> List.of(text(analysis.renameTarget(position)));
      case "selectionRanges" ->
          analysis.selectionRanges(position).stream().map(Answers::text).toList();
      case "inlayHints" -> hints(analysis);
      default -> calls(question, analysis);
    };
  }

  private List<String> hints(Analysis analysis) {
    TextRange whole = new TextRange(new TextPosition(0, 0), new TextPosition(Integer.MAX_VALUE, 0));
    return analysis.inlayHints(whole).stream()
        .map(each -> text(each.position()) + each.text())
        .toList();
  }

  private List<String> calls(String question, Analysis analysis) {
    List<String> lines = new ArrayList<>();
    for (Call.Item item : analysis.callItems(position)) {
      List<Call> calls =
          switch (question) {
            case "callItems" -> List.of(new Call(item, List.of(item.nameRange())));
            case "incomingCalls" -> service.incomingCalls(item);
            case "outgoingCalls" -> service.outgoingCalls(item);
            default -> throw new IllegalArgumentException(question);
          };
      for (Call call : calls) {
        String places = call.places().stream().map(Answers::text).toList().toString();
        lines.add(call.other().kind() + " " + call.other().name() + " " + places);
      }
    }
    return lines;
  }

  private static List<String> symbols(List<Symbol> symbols, String indentation) {
    List<String> lines = new ArrayList<>();
    for (Symbol each : symbols) {
      String detail = each.detail().isEmpty() ? "" : " " + each.detail();
      lines.add(
          "%s%s %s%s %s"
              .formatted(indentation, each.kind(), each.name(), detail, text(each.range())));
      lines.addAll(symbols(each.children(), indentation + "  "));
    }
    return lines;
  }

  private List<String> places(List<FileRange> places) {
    return places.stream().map(each -> place(each.file(), each.range())).toList();
  }

  private String place(Path other, TextRange range) {
    String name = other.equals(file) ? "" : other.getFileName() + " ";
    return name + text(range);
  }

  private static String text(TextRange range) {
    return text(range.start()) + "-" + text(range.end());
  }

  private static String text(TextPosition position) {
    return position.line() + ":" + position.column();
  }

  private static String text(Completion each) {
    return "%s %s [%s] %s %s"
        .formatted(
            each.kind(), each.label(), each.insertText(), text(each.replaced()), each.detail());
  }

  private static List<String> text(SignatureHelp help) {
    return help.signatures().stream()
        .map(each -> each.label() + " at " + help.activeParameter())
        .toList();
  }

  private static String text(RenameTarget target) {
    return target.isAllowed() ? text(target.range()) : "refused: " + target.refusal();
  }

  private static String text(Folding each) {
    return each.kind() + " " + each.firstLine() + "-" + each.lastLine();
  }

  private static String text(SemanticToken each) {
    String place = each.line() + ":" + each.column() + "+" + each.length();
    return place + " " + each.kind() + (each.declaration() ? " declaration" : "");
  }
}
