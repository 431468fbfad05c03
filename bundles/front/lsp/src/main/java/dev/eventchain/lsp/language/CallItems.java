package dev.eventchain.lsp.language;

import com.google.gson.JsonPrimitive;
import dev.eventchain.editing.Call;
import dev.eventchain.editing.ElementKind;
import dev.eventchain.editing.FileRange;
import dev.eventchain.lsp.text.Positions;
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

  private CallItems() {}

  /** Returns an item that the editor can ask about later. */
  public static CallHierarchyItem of(Call.Item item) {
    CallHierarchyItem converted =
        new CallHierarchyItem(
            item.name(),
            Protocol.symbolKind(item.kind()),
            item.place().file().toUri().toString(),
            Positions.of(item.place().range()),
            Positions.of(item.nameRange()));
    converted.setDetail(item.detail());
    converted.setData(item.kind().name());
    return converted;
  }

  private static Optional<Call.Item> item(CallHierarchyItem item) {
    // An editor sends back what it was given, as JSON.
    String kind =
        item.getData() instanceof JsonPrimitive text
            ? text.getAsString()
            : String.valueOf(item.getData());
    return Positions.path(item.getUri())
        .map(
            path ->
                new Call.Item(
                    item.getName(),
                    Optional.ofNullable(item.getDetail()).orElse(""),
                    ElementKind.valueOf(kind),
                    new FileRange(path, Positions.of(item.getRange())),
                    Positions.of(item.getSelectionRange())));
  }

  /** Returns who calls an item. */
  public static List<CallHierarchyIncomingCall> incoming(
      Languages languages, CallHierarchyItem item) {
    return calls(
        languages,
        item,
        (service, asked) -> service.incomingCalls(asked),
        (call, ranges) -> new CallHierarchyIncomingCall(of(call.other()), ranges));
  }

  /** Returns what an item calls. */
  public static List<CallHierarchyOutgoingCall> outgoing(
      Languages languages, CallHierarchyItem item) {
    return calls(
        languages,
        item,
        (service, asked) -> service.outgoingCalls(asked),
        (call, ranges) -> new CallHierarchyOutgoingCall(of(call.other()), ranges));
  }

  private static <T> List<T> calls(
      Languages languages,
      CallHierarchyItem item,
      BiFunction<dev.eventchain.editing.LanguageService, Call.Item, List<Call>> question,
      BiFunction<Call, List<Range>, T> converted) {
    Optional<Call.Item> asked = item(item);
    return asked
        .flatMap(it -> languages.of(fileOf(it)))
        .map(service -> question.apply(service, asked.orElseThrow()))
        .orElse(List.of())
        .stream()
        .map(call -> converted.apply(call, call.places().stream().map(Positions::of).toList()))
        .toList();
  }

  private static Path fileOf(Call.Item item) {
    return item.place().file();
  }
}
