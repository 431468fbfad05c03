package dev.eventchain.roads.xml;

import dev.eventchain.diagnostics.ResourceText;
import java.util.HashMap;
import java.util.Map;
import java.util.TreeMap;

/**
 * Treatment of each element of OpenDRIVE: read, without effect, or refused because roads would be
 * different without it. The table is a file beside this class.
 */
public final class ElementTable {

  /** Treatment of an element. */
  enum Treatment {
    /** Read. */
    READ,
    /** Skipped with all that it contains. */
    SKIPPED,
    /** Reported as an error. */
    REFUSED
  }

  /**
   * A line of the table.
   *
   * @param reason empty for what is read
   */
  record Entry(Treatment treatment, String reason) {}

  /**
   * Entries by {@code parent/child}; elements that may be anywhere are <code>*&#47;child</code>.
   */
  static final Map<String, Entry> ENTRIES = entries();

  /** The same by parent and then by child, as they are looked up for each element of a file. */
  private static final Map<String, Map<String, Entry>> BY_PARENT = byParent();

  private ElementTable() {}

  private static Map<String, Map<String, Entry>> byParent() {
    Map<String, Map<String, Entry>> table = new HashMap<>();
    ENTRIES.forEach(
        (name, entry) -> {
          String[] parts = name.split("/", 2);
          table.computeIfAbsent(parts[0], parent -> new HashMap<>()).put(parts[1], entry);
        });
    return table;
  }

  private static Entry entry(String parent, String child) {
    Entry entry = BY_PARENT.getOrDefault(parent, Map.of()).get(child);
    return entry == null ? BY_PARENT.get("*").get(child) : entry;
  }

  private static Map<String, Entry> entries() {
    Map<String, Entry> entries = new TreeMap<>();
    text()
        .lines()
        .filter(line -> !line.isBlank() && !line.startsWith("#"))
        .forEach(
            line -> {
              String[] parts = (line + " ").split(" ", 3);
              entries.put(parts[0], new Entry(Treatment.valueOf(parts[1]), parts[2].strip()));
            });
    return entries;
  }

  private static String text() {
    return ResourceText.of(ElementTable.class, "elements.txt");
  }

  /** Reports what is refused or unknown in a child of the root. */
  public static void check(CheckedElement element, Problems problems) {
    check("OpenDRIVE", element, problems);
  }

  private static void check(String parent, CheckedElement element, Problems problems) {
    Entry entry = entry(parent, element.name());
    if (entry == null) {
      problems.add(
          XmlRules.ELEMENT_UNKNOWN,
          element,
          "`" + element.name() + "` in `" + parent + "` is not part of OpenDRIVE up to 1.8.",
          "It has no effect. Data of your own belong into `userData`.");
    } else if (entry.treatment == Treatment.REFUSED && !isHarmless(element)) {
      problems.add(
          XmlRules.ELEMENT_UNSUPPORTED,
          element,
          "`" + element.name() + "` is not supported: " + entry.reason + ".",
          "Export the file without it, or remove it if the difference does not matter.");
    } else if (entry.treatment == Treatment.READ) {
      element.children().forEach(child -> check(element.name(), child, problems));
    }
  }

  /** Returns whether a description of a surface changes the friction only. */
  private static boolean isHarmless(CheckedElement element) {
    return element.name().equals("CRG")
        && element.optional("purpose").filter("friction"::equals).isPresent();
  }
}
