package dev.eventchain.project.requirements;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.WrittenRequirement.Details;
import dev.eventchain.model.WrittenRequirement.Parent;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** An item of a source while it is read, whether it counts as a requirement or not. */
final class Item {

  final String id;
  final String text;
  final SourceLocation location;
  Optional<String> type = Optional.empty();
  Optional<String> status = Optional.empty();
  List<String> tags = List.of();
  final List<Parent> parents = new ArrayList<>();

  /** Types that are more general than its own, which a selection may name, too. */
  Set<String> generalTypes = Set.of();

  /** Reason why it is no requirement for its own tool; empty if it is one. */
  Optional<String> excluded = Optional.empty();

  Item(String id, String text, SourceLocation location) {
    this.id = id.strip();
    this.text = plain(text);
    this.location = location;
  }

  /** Returns a text on one line, without control characters, which foreign files may hold. */
  private static String plain(String text) {
    return text.replaceAll("[\\s\\p{Cc}]+", " ").strip();
  }

  /** Makes what readers have set plain, too. */
  void simplify() {
    type = type.map(Item::plain);
    status = status.map(Item::plain);
    tags = tags.stream().map(Item::plain).toList();
    parents.replaceAll(parent -> new Parent(plain(parent.id()), parent.location()));
  }

  /** Adds a parent, unless it is known or the item itself. */
  void addParent(String parent, SourceLocation place) {
    String name = parent.strip();
    if (!name.isEmpty() && !name.equals(id)) {
      parents.add(new Parent(name, place));
    }
  }

  WrittenRequirement written() {
    Map<String, Parent> each = new LinkedHashMap<>();
    parents.forEach(parent -> each.putIfAbsent(parent.id(), parent));
    Details details = new Details(type, status, tags, List.copyOf(each.values()));
    return new WrittenRequirement(id, text, location, details);
  }
}
