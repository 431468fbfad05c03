package dev.eventchain.project.requirements;

import static java.util.stream.Collectors.groupingBy;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;

/** Results of reading a source: items, in the order of the source, and findings. */
final class Reading {

  /** Greatest number of characters of a file. */
  static final int LONGEST = 32 << 20;

  final RequirementSource.Fields fields;

  /** The types that count; empty if all do. */
  final List<String> types;

  final List<Item> items = new ArrayList<>();
  final List<Diagnostic> findings = new ArrayList<>();
  private final List<Downward> downward = new ArrayList<>();

  private final List<Referred> referred = new ArrayList<>();
  private final Map<String, Item> named = new HashMap<>();

  private record Downward(String child, String parent, SourceLocation place) {}

  private record Referred(Item child, String name, SourceLocation place) {}

  Reading(RequirementSource.Fields fields, List<String> types) {
    this.fields = fields;
    this.types = types;
  }

  /** Adds a link from a parent to its child, which may be read later. */
  void addChild(String parent, String child, SourceLocation place) {
    downward.add(new Downward(child.strip(), parent, place));
  }

  /** Adds an item under the name by which others refer to it, which may not be its id. */
  void addNamed(String name, Item item) {
    items.add(item);
    named.put(name, item);
  }

  /** Adds a reference to a parent by its name. */
  void refer(Item child, String name, SourceLocation place) {
    referred.add(new Referred(child, name, place));
  }

  /**
   * Gives each child its parents, after all items were read; a child that nothing describes is a
   * finding.
   */
  void link() {
    for (Referred each : referred) {
      Item parent = named.get(each.name);
      each.child.addParent(parent == null ? each.name : parent.id, each.place);
    }
    Map<String, List<Item>> byId =
        downward.isEmpty() ? Map.of() : items.stream().collect(groupingBy(item -> item.id));
    for (Downward each : downward) {
      List<Item> children = byId.getOrDefault(each.child, List.of());
      children.forEach(it -> it.addParent(each.parent, each.place));
      if (children.isEmpty()) {
        String message = "'%s' is said to have the child '%s', which is not there.";
        findings.add(
            Diagnostic.of(
                RequirementRules.PARENT, message.formatted(each.parent, each.child), each.place));
      }
    }
    items.forEach(Item::simplify);
  }

  /**
   * Reads a file; what cannot be read of it is a finding.
   *
   * @return what the reader returns; empty if it could not go on
   */
  static <T> Optional<T> file(
      Path file, Reading reading, Function<SourceText, Optional<T>> reader) {
    try {
      SourceText text = SourceText.read(file);
      if (text.text().length() > LONGEST) {
        throw refused(
            "The file is longer than " + LONGEST + " characters.",
            SourceLocation.of(file),
            "Divide it.");
      }
      return reader.apply(text);
    } catch (DiagnosticException e) {
      reading.findings.addAll(e.diagnostics());
      return Optional.empty();
    }
  }

  /** Reports what cannot be read, and goes on. */
  void unread(String message, SourceLocation place, String hint) {
    findings.add(refusal(message, place, hint));
  }

  /** Reports what is passed over, by a rule. */
  void unread(String message, SourceLocation place, String hint, Rule rule) {
    findings.add(Diagnostic.of(rule, message, place).withHint(hint));
  }

  /** Returns the exception for a file that cannot be read. */
  static DiagnosticException refused(String message, SourceLocation place, String hint) {
    return new DiagnosticException(DiagnosticException.Reason.INPUT, refusal(message, place, hint));
  }

  private static Diagnostic refusal(String message, SourceLocation place, String hint) {
    return Diagnostic.of(RequirementRules.SOURCE, message, place).withHint(hint);
  }

  /** Returns the parts of a list that is written as one text: {@code a, b; c}. */
  static List<String> parts(String list) {
    return Stream.of(list.split("[,;\\n]", -1))
        .map(String::strip)
        .filter(part -> !part.isEmpty())
        .toList();
  }
}
