package dev.eventchain.ocl.assist;

import dev.eventchain.editing.Call;
import dev.eventchain.editing.TextRange;
import dev.eventchain.ocl.editing.Mention;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Calls in the texts of a language. */
public final class Calls {

  private Calls() {}

  /** Returns the calls of something that is declared in a text. */
  public static List<Call> incoming(AssistedText text, Call.Item item) {
    List<Object> wanted =
        text.mentionAt(item.nameRange().start()).map(text::targets).orElse(List.of());
    Map<Call.Item, List<TextRange>> callers = new LinkedHashMap<>();
    for (AssistedText each : text.family()) {
      for (Mention mention : each.mentions()) {
        boolean calls = each.targets(mention).stream().anyMatch(wanted::contains);
        Optional<Call.Item> caller = calls ? each.itemAround(mention.start()) : Optional.empty();
        // A name in a head, such as that of the declaration itself, calls nothing.
        caller
            .filter(found -> each.places().stream().anyMatch(p -> p.touches(mention.start())))
            .ifPresent(
                found ->
                    callers
                        .computeIfAbsent(found, none -> new ArrayList<>())
                        .add(each.range(mention)));
      }
    }
    return calls(callers);
  }

  /** Returns what something calls that is declared in a text. */
  public static List<Call> outgoing(AssistedText text, Call.Item item) {
    int start = text.lines().offset(item.place().range().start());
    int end = text.lines().offset(item.place().range().end());
    Map<Call.Item, List<TextRange>> called = new LinkedHashMap<>();
    for (ExpressionPlace place : text.places()) {
      if (place.range().start() >= start && place.range().end() <= end) {
        for (Mention mention : place.mentions()) {
          for (Object target : text.targets(mention)) {
            text.itemOf(target)
                .ifPresent(
                    found ->
                        called
                            .computeIfAbsent(found, none -> new ArrayList<>())
                            .add(text.range(mention)));
          }
        }
      }
    }
    return calls(called);
  }

  private static List<Call> calls(Map<Call.Item, List<TextRange>> places) {
    return places.entrySet().stream()
        .map(each -> new Call(each.getKey(), List.copyOf(each.getValue())))
        .toList();
  }
}
