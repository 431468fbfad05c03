package dev.eventchain.project.requirements;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.WrittenRequirement;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * The requirements of a source in the format of another tool: those of its items that count.
 *
 * @param items those that count, in the order of the source
 * @param known the ids of all items, also of those that do not count
 * @param diagnostics what could not be read, and what does not count
 */
public record SourceRequirements(
    List<WrittenRequirement> items, Set<String> known, List<Diagnostic> diagnostics) {

  private static final int LONGEST_ID = 200;

  /** Near names are looked for this often; in large sources it takes long. */
  private static final int MOST_HINTS = 50;

  /** Copies the collections. */
  public SourceRequirements {
    items = List.copyOf(items);
    known = Set.copyOf(known);
    diagnostics = List.copyOf(diagnostics);
  }

  /**
   * Returns the files that may be read of a source. They need not exist.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT if a folder cannot be read
   */
  public static List<Path> files(RequirementSource source) {
    return SourceFiles.of(source);
  }

  /**
   * Reads a source.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT if the file or folder cannot be
   *     read at all
   */
  public static SourceRequirements read(RequirementSource source) {
    Reading reading = new Reading(source.fields(), source.only().types());
    SourceFiles.read(source, reading);
    reading.link();
    List<Diagnostic> found = new ArrayList<>(reading.findings);
    List<WrittenRequirement> items = new ArrayList<>();
    Map<String, Integer> left = new TreeMap<>();
    for (Item item : reading.items) {
      Optional<String> reason = item.excluded.or(() -> unwanted(item, source.only()));
      if (reason.isPresent()) {
        left.merge(reason.get(), 1, Integer::sum);
      } else {
        check(item).ifPresent(found::add);
        items.add(item.written());
      }
    }
    SourceLocation place = SourceLocation.of(source.file());
    if (!left.isEmpty()) {
      found.add(filtered(items.size(), left, place));
    }
    unmatched(source, reading.items, found);
    if (items.isEmpty() && !Diagnostic.anyError(found)) {
      found.add(
          Diagnostic.of(
                  RequirementRules.NONE, "No item of this source counts as a requirement.", place)
              .withHint("Widen 'only' of the source in eventchain.yaml, or name another one."));
    }
    Set<String> known = reading.items.stream().map(item -> item.id).collect(Collectors.toSet());
    return new SourceRequirements(items, known, found);
  }

  /** Returns why an item does not count; empty if it does. */
  private static Optional<String> unwanted(Item item, RequirementSource.Only only) {
    List<String> types = new ArrayList<>(item.generalTypes);
    item.type.ifPresent(types::add);
    if (!meets(only.types(), types)) {
      return Optional.of(item.type.map(type -> "of type '" + type + "'").orElse("without a type"));
    } else if (!meets(only.statuses(), item.status.stream().toList())) {
      return Optional.of(
          item.status.map(status -> "of status '" + status + "'").orElse("without a status"));
    } else if (!meets(only.tags(), item.tags)) {
      return Optional.of("without any of the tags");
    }
    return Optional.empty();
  }

  private static boolean meets(List<String> wanted, Collection<String> given) {
    return wanted.isEmpty() || given.stream().anyMatch(wanted::contains);
  }

  private static Diagnostic filtered(int counted, Map<String, Integer> left, SourceLocation place) {
    String reasons =
        left.entrySet().stream()
            .map(each -> each.getKey() + " (" + each.getValue() + ")")
            .collect(Collectors.joining(", "));
    int sum = left.values().stream().mapToInt(Integer::intValue).sum();
    return Diagnostic.of(
        RequirementRules.FILTERED,
        String.format(
            Locale.ROOT,
            "%d of %d items count as requirements. The others: %s.",
            counted,
            counted + sum,
            reasons),
        place);
  }

  /** Reports values of the selection that no item has, which may be misspelt. */
  private static void unmatched(
      RequirementSource source, List<Item> items, List<Diagnostic> found) {
    RequirementSource.Only only = source.only();
    Set<String> types = new TreeSet<>();
    items.forEach(item -> types.addAll(item.generalTypes));
    items.forEach(item -> item.type.ifPresent(types::add));
    unmatched("type", only.types(), types, source, found);
    unmatched(
        "status", only.statuses(), all(items, it -> it.status.stream().toList()), source, found);
    unmatched("tag", only.tags(), all(items, it -> it.tags), source, found);
  }

  private static Set<String> all(List<Item> items, Function<Item, List<String>> values) {
    return items.stream()
        .flatMap(item -> values.apply(item).stream())
        .collect(Collectors.toCollection(TreeSet::new));
  }

  private static void unmatched(
      String kind,
      List<String> wanted,
      Set<String> given,
      RequirementSource source,
      List<Diagnostic> found) {
    for (String each : wanted) {
      if (!given.contains(each)) {
        found.add(
            Diagnostic.of(
                    RequirementRules.SELECTION,
                    "No item of %s has the %s '%s'."
                        .formatted(SourceLocation.of(source.file()).file(), kind, each),
                    source.place())
                .withHint(NearestName.hint(each, given)));
      }
    }
  }

  private static Optional<Diagnostic> check(Item item) {
    if (item.id.isEmpty()) {
      return Optional.of(
          Diagnostic.of(RequirementRules.ID, "This requirement has no id.", item.location)
              .withHint(
                  "Give it one; if another field holds it, name that in eventchain.yaml: fields:"
                      + " {id: NAME}"));
    }
    boolean unusable =
        item.id.length() > LONGEST_ID
            || item.id.chars().anyMatch(c -> c == ',' || Character.isISOControl(c));
    if (unusable) {
      String message = "'%s' cannot be an id here: results list ids on one line, with commas.";
      String shown = item.id.substring(0, Math.min(item.id.length(), 60));
      return Optional.of(
          Diagnostic.of(RequirementRules.ID, message.formatted(shown), item.location)
              .withHint("Use letters, digits and any of -_./: in at most 200 characters."));
    }
    if (item.text.isEmpty()) {
      return Optional.of(
          Diagnostic.of(
                  RequirementRules.EMPTY, "The item " + item.id + " has no text.", item.location)
              .withHint(
                  "Write it; if another field holds it, name that in eventchain.yaml: fields:"
                      + " {text: NAME}"));
    }
    return Optional.empty();
  }

  /**
   * Returns a finding for each parent that no source has.
   *
   * @param known the ids of all sources
   */
  public static List<Diagnostic> unknownParents(
      List<WrittenRequirement> items, Collection<String> known) {
    Set<String> ids = new TreeSet<>(known);
    Map<String, String> hints = new HashMap<>();
    List<Diagnostic> found = new ArrayList<>();
    for (WrittenRequirement item : items) {
      for (WrittenRequirement.Parent parent : item.details().parents()) {
        if (!ids.contains(parent.id())) {
          found.add(
              Diagnostic.of(
                      RequirementRules.PARENT,
                      "The parent '%s' of %s is in no source of requirements."
                          .formatted(parent.id(), item.id()),
                      parent.location())
                  .withHint(
                      hints.size() < MOST_HINTS
                          ? hints.computeIfAbsent(
                              parent.id(), unknown -> NearestName.hint(unknown, ids))
                          : hints.getOrDefault(parent.id(), "")));
        }
      }
    }
    return found;
  }

  /** Returns the form of an id in which two ids are the same one. */
  public static String plainId(String id) {
    return id.toLowerCase(Locale.ROOT);
  }
}
