package dev.eventchain.catalogue;

import dev.eventchain.catalogue.signal.CatalogueSignal;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Signals that differ only in the instance that they belong to, such as those of each seat.
 *
 * @param path their paths at once: "Vehicle.Cabin.Door.{Row1,Row2}.{Left,Right}.IsOpen"
 * @param signals the signals, one for each choice of the braces
 */
public record SignalGroup(String path, List<CatalogueSignal> signals) {

  /** Copies the list. */
  public SignalGroup {
    signals = List.copyOf(signals);
  }

  /** Returns the groups of signals, in the order of the first signal of each. */
  public static List<SignalGroup> of(List<CatalogueSignal> signals) {
    Map<Object, List<CatalogueSignal>> alike = new LinkedHashMap<>();
    for (CatalogueSignal signal : signals) {
      alike.computeIfAbsent(properties(signal), key -> new ArrayList<>()).add(signal);
    }
    return alike.values().stream().flatMap(each -> grouped(each, 0).stream()).toList();
  }

  /** Returns any of the signals, which mean the same but for the instance. */
  public CatalogueSignal any() {
    return signals.get(0);
  }

  /** Returns what the signals of a group have in common. */
  private static List<Object> properties(CatalogueSignal signal) {
    List<String> names = names(signal);
    return List.of(
        names.size(),
        names.get(names.size() - 1),
        signal.role(),
        signal.type(),
        signal.unit(),
        signal.least(),
        signal.most(),
        signal.allowed(),
        signal.names(),
        signal.description(),
        signal.groups());
  }

  private static List<String> names(CatalogueSignal signal) {
    return List.of(signal.path().split("\\."));
  }

  /** Returns the groups of signals with paths of one length, from a part of their paths on. */
  private static List<SignalGroup> grouped(List<CatalogueSignal> signals, int part) {
    if (part == names(signals.get(0)).size()) {
      return List.of(new SignalGroup("", signals));
    }
    Map<String, List<CatalogueSignal>> byName = new LinkedHashMap<>();
    signals.forEach(
        signal ->
            byName.computeIfAbsent(names(signal).get(part), key -> new ArrayList<>()).add(signal));
    Map<List<String>, List<String>> namesByRest = new LinkedHashMap<>();
    Map<String, List<SignalGroup>> rests = new LinkedHashMap<>();
    byName.forEach(
        (name, some) -> {
          List<SignalGroup> rest = grouped(some, part + 1);
          rests.put(name, rest);
          List<String> paths = rest.stream().map(SignalGroup::path).toList();
          namesByRest.computeIfAbsent(paths, key -> new ArrayList<>()).add(name);
        });
    List<SignalGroup> groups = new ArrayList<>();
    namesByRest.forEach((paths, names) -> groups.addAll(joined(paths, names, rests)));
    return groups;
  }

  private static List<SignalGroup> joined(
      List<String> paths, List<String> names, Map<String, List<SignalGroup>> rests) {
    String head = names.size() == 1 ? names.get(0) : "{" + String.join(",", names) + "}";
    List<SignalGroup> groups = new ArrayList<>();
    for (int i = 0; i < paths.size(); i++) {
      List<CatalogueSignal> all = new ArrayList<>();
      for (String name : names) {
        all.addAll(rests.get(name).get(i).signals());
      }
      String rest = paths.get(i);
      groups.add(new SignalGroup(rest.isEmpty() ? head : head + "." + rest, all));
    }
    return groups;
  }
}
