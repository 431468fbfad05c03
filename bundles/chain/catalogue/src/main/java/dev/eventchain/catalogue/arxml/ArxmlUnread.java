package dev.eventchain.catalogue.arxml;

import dev.eventchain.catalogue.signal.CatalogueRules;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/** Parts of a description that are not read: one finding for each kind of them. */
final class ArxmlUnread {

  /** Names that a finding lists. */
  private static final int LISTED = 5;

  /** Kind of what is not read. */
  enum Kind {
    PDU(
        "It is in no frame on CAN that is read, so its signals are not read",
        "These PDUs are in no frame on CAN that is read, so their signals are not read"),
    LENGTH(
        "It does not have 1 to 64 bits, so it is not read",
        "These signals do not have 1 to 64 bits, so they are not read"),
    ENCODING(
        "It is a text, a list, or a number of another encoding, so it is not read",
        "These signals are texts, lists, or numbers of other encodings, so they are not read"),
    CURVE(
        "Its values are no line over its numbers, so its signals are not read",
        "The values of these methods are no line over their numbers, so their signals are not read"),
    MASK(
        "Texts of single bits are not read: its signals are numbers without texts",
        "Texts of single bits are not read: the signals of these methods are numbers without texts"),
    WIDE(
        "A text of more than 256 numbers is not read as their name",
        "Texts of more than 256 numbers are not read as their names"),
    SIGN(
        "It has no base type, so its number is read without a sign",
        "These signals have no base type, so their numbers are read without a sign"),
    INITIAL(
        "Its initial value is no number, so it is not read",
        "The initial values of these signals are no numbers, so they are not read"),
    UNIT(
        "It has no display name, and none follows from its dimension: its signals have no unit",
        "These units have no display names, and none follow from their dimensions: their signals have no unit"),
    UNITS(
        "It states several units, of which the first one counts",
        "These signals state several units, of which the first ones count"),
    CONSTRAINT(
        "Its limits are in another unit than that of the signal, so they are not read",
        "The limits of these signals are in other units than theirs, so they are not read"),
    VARIANT(
        "It is only in some variants of the vehicle, and is read as if it were in all",
        "These are only in some variants of the vehicle, and are read as if they were in all"),
    OTHER_VARIANT(
        "Another variant of it is before it, and is read alone",
        "Other variants of these are before them, and are read alone");

    private final String one;
    private final String several;

    Kind(String one, String several) {
      this.one = one;
      this.several = several;
    }
  }

  /** An example with its place. */
  private record Noted(String name, SourceLocation place) {}

  private final Map<Kind, Map<String, Noted>> noted = new EnumMap<>(Kind.class);

  void note(Kind kind, String name, SourceLocation place) {
    noted
        .computeIfAbsent(kind, key -> new LinkedHashMap<>())
        .putIfAbsent(name, new Noted(name, place));
  }

  /** Notes an element that is only there in some variants. */
  void noteVariants(ArxmlElement element, String name) {
    if (element.isVariant()) {
      note(Kind.VARIANT, name, element.location());
    }
  }

  /** Reports all that was noted. */
  void report(Consumer<Diagnostic> findings) {
    noted.forEach(
        (kind, all) -> {
          List<Noted> each = new ArrayList<>(all.values());
          String names =
              String.join(
                  ", ", each.stream().limit(LISTED).map(it -> "'" + it.name() + "'").toList());
          int more = each.size() - LISTED;
          String message =
              (each.size() == 1 ? kind.one : kind.several)
                  + ": "
                  + names
                  + (more > 0 ? " and " + more + " more" : "")
                  + ".";
          findings.accept(Diagnostic.of(CatalogueRules.UNREAD, message, each.get(0).place()));
        });
  }
}
