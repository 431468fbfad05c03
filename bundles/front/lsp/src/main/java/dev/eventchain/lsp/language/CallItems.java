package dev.eventchain.lsp.language;

import dev.eventchain.editing.Call;
import dev.eventchain.editing.ElementKind;
import dev.eventchain.editing.FileRange;
import dev.eventchain.lsp.text.Edits;
import dev.eventchain.lsp.text.Positions;
import dev.eventchain.lsp.text.ProtocolJson;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import org.eclipse.lsp4j.CallHierarchyIncomingCall;
import org.eclipse.lsp4j.CallHierarchyItem;
import org.eclipse.lsp4j.CallHierarchyOutgoingCall;
import org.eclipse.lsp4j.Range;

/** Call hierarchy in the words of the protocol. */
public final class CallItems {

  private final Languages languages;
  private final Edits edits;

  /** Creates the items of a session. */
  public CallItems(Languages languages, Edits edits) {
    this.languages = languages;
    this.edits = edits;
  }

  /** Returns an item that the editor can ask about later. */
  public CallHierarchyItem of(Call.Item item) {
    CallHierarchyItem converted =
        new CallHierarchyItem(
            item.name(),
            Protocol.symbolKind(item.kind()),
            item.place().file().toUri().toString(),
            edits.range(fileOf(item), item.place().range()),
            edits.range(fileOf(item), item.nameRange()));
    converted.setDetail(item.detail());
    converted.setData(item.kind().name());
    return converted;
  }

  private Optional<Call.Item> item(CallHierarchyItem item) {
    // An editor sends back what it was given.
    String kind = ProtocolJson.of(item.getData()).asText();
    return Positions.path(item.getUri())
        .map(
            path ->
                new Call.Item(
                    item.getName(),
                    Optional.ofNullable(item.getDetail()).orElse(""),
                    ElementKind.valueOf(kind),
                    new FileRange(path, edits.range(path, item.getRange())),
                    edits.range(path, item.getSelectionRange())));
  }

  /** Returns who calls an item. */
  public List<CallHierarchyIncomingCall> incoming(CallHierarchyItem item) {
    return calls(
        item,
        (service, asked) -> service.incomingCalls(asked),
        (asked, call) -> call.other(),
        (call, ranges) -> new CallHierarchyIncomingCall(of(call.other()), ranges));
  }

  /** Returns what an item calls. */
  public List<CallHierarchyOutgoingCall> outgoing(CallHierarchyItem item) {
    return calls(
        item,
        (service, asked) -> service.outgoingCalls(asked),
        (asked, call) -> asked,
        (call, ranges) -> new CallHierarchyOutgoingCall(of(call.other()), ranges));
  }

  /**
   * Returns the calls of an item.
   *
   * @param caller who calls, in whose file the places are
   */
  private <T> List<T> calls(
      CallHierarchyItem item,
      BiFunction<dev.eventchain.editing.LanguageService, Call.Item, List<Call>> question,
      BiFunction<Call.Item, Call, Call.Item> caller,
      BiFunction<Call, List<Range>, T> converted) {
    Optional<Call.Item> asked = item(item);
    return asked
        .flatMap(it -> languages.of(fileOf(it)))
        .map(service -> question.apply(service, asked.orElseThrow()))
        .orElse(List.of())
        .stream()
        .map(
            call -> {
              Path file = fileOf(caller.apply(asked.orElseThrow(), call));
              return converted.apply(
                  call, call.places().stream().map(each -> edits.range(file, each)).toList());
            })
        .toList();
  }

  private static Path fileOf(Call.Item item) {
    return item.place().file();
  }
}
