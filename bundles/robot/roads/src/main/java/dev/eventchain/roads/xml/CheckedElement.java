package dev.eventchain.roads.xml;

import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.XmlEvents;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * An element with its attributes, children and place. Reads of attributes report what is wrong with
 * them and return a stand-in, {@code NaN} or an empty text, so that one reading finds all problems.
 */
public final class CheckedElement {

  /** Attributes that tell elements of a name apart, the first one first. */
  private static final List<String> IDENTIFYING = List.of("id", "s", "sOffset");

  /** Largest number that is read: cubes of such numbers are finite, and no road needs more. */
  private static final double LARGEST = 1e12;

  private final SourceText source;
  private final Problems problems;
  private final String name;
  private final int offset;
  private final CheckedElement parent;

  /** Names and values in turn: a table for each of a million elements takes longer to make. */
  private final String[] attributes;

  private final List<CheckedElement> children = new ArrayList<>(0);
  private String text = "";

  CheckedElement(
      SourceText source,
      Problems problems,
      String name,
      int offset,
      CheckedElement parent,
      String[] attributes) {
    this.source = source;
    this.problems = problems;
    this.name = name;
    this.offset = offset;
    this.parent = parent;
    this.attributes = attributes;
    if (parent != null) {
      parent.children.add(this);
    }
  }

  void append(String more) {
    text = text.isEmpty() ? more : text + more;
  }

  /** Returns the local name. */
  public String name() {
    return name;
  }

  /** Returns the text without white space at its ends. */
  public String text() {
    return text.strip();
  }

  /** Returns the parent; null for a child of the document's root. */
  CheckedElement parent() {
    return parent;
  }

  /** Returns all children. */
  public List<CheckedElement> children() {
    return children;
  }

  /** Returns the children of a name. */
  public List<CheckedElement> children(String childName) {
    List<CheckedElement> found = List.of();
    for (CheckedElement child : children) {
      if (child.name.equals(childName)) {
        found = found.isEmpty() ? new ArrayList<>() : found;
        found.add(child);
      }
    }
    return found;
  }

  /** Returns the grandchildren of a name below children of another one. */
  public List<CheckedElement> children(String childName, String grandchildName) {
    List<CheckedElement> found = new ArrayList<>(0);
    for (CheckedElement child : children) {
      if (child.name.equals(childName)) {
        found.addAll(child.children(grandchildName));
      }
    }
    return found;
  }

  /** Returns the first child of a name. */
  public Optional<CheckedElement> child(String childName) {
    for (CheckedElement child : children) {
      if (child.name.equals(childName)) {
        return Optional.of(child);
      }
    }
    return Optional.empty();
  }

  /** Returns the first child of a name; reports that there is none. */
  public Optional<CheckedElement> requiredChild(String childName) {
    Optional<CheckedElement> child = child(childName);
    if (child.isEmpty()) {
      problems.add(
          XmlRules.ELEMENT_MISSING,
          this,
          "`" + name + "` has no `" + childName + "`.",
          "Add the element, or export the file again.");
    }
    return child;
  }

  /** Returns the value of an attribute; null if there is none. */
  private String value(String attribute) {
    for (int i = 0; i < attributes.length; i += 2) {
      if (attributes[i].equals(attribute)) {
        return attributes[i + 1];
      }
    }
    return null;
  }

  private List<String> names() {
    return IntStream.range(0, attributes.length / 2).mapToObj(i -> attributes[2 * i]).toList();
  }

  /** Returns the value of an attribute. */
  public Optional<String> optional(String attribute) {
    return Optional.ofNullable(value(attribute));
  }

  /** Returns the value of an attribute; an empty text, and a problem, if there is none. */
  public String string(String attribute) {
    String value = value(attribute);
    if (value == null) {
      missing(attribute);
      return "";
    }
    return value;
  }

  private void missing(String attribute) {
    String question = NearestName.question(attribute, names());
    problems.add(
        XmlRules.ATTRIBUTE_MISSING,
        this,
        "`" + name + "` has no attribute `" + attribute + "`.",
        question.isEmpty() ? "Add the attribute, or export the file again." : question);
  }

  /** Returns the finite number of an attribute; {@code NaN}, and a problem, if it is none. */
  public double number(String attribute) {
    String value = value(attribute);
    if (value == null) {
      missing(attribute);
      return Double.NaN;
    }
    return parsed(attribute, value);
  }

  /** Returns the finite number of an attribute, or a value if there is no such attribute. */
  public double number(String attribute, double absent) {
    String value = value(attribute);
    return value == null ? absent : parsed(attribute, value);
  }

  /** Returns the number of an attribute as far as it can be read; else {@code NaN}, no problem. */
  public double numberOrNaN(String attribute) {
    String value = value(attribute);
    double number = value == null ? Double.NaN : decimal(value.strip());
    return Math.abs(number) <= LARGEST ? number : Double.NaN;
  }

  /** Returns whether an attribute is a number that can be read; reports nothing. */
  public boolean isNumber(String attribute) {
    return !Double.isNaN(numberOrNaN(attribute));
  }

  private double parsed(String attribute, String value) {
    double number = decimal(value.strip());
    if (!Double.isFinite(number)) {
      problems.add(
          XmlRules.NUMBER,
          at(attribute),
          "`" + attribute + "` is `" + shortened(value) + "`, which is no finite number.",
          "Write a decimal number, such as `12.5` or `1.2e-3`.");
      return Double.NaN;
    }
    if (Math.abs(number) > LARGEST) {
      problems.add(
          XmlRules.NUMBER,
          at(attribute),
          "`" + attribute + "` is `" + shortened(value) + "`, and no road is described by that.",
          "Numbers up to 1e12 are read, in m, rad or per m.");
      return Double.NaN;
    }
    return number;
  }

  /** Java's numbers may also be hexadecimal, have a type suffix, or be called {@code Infinity}. */
  private static double decimal(String value) {
    boolean plain = !value.isEmpty();
    for (int i = 0; plain && i < value.length(); i++) {
      char each = value.charAt(i);
      plain = (each >= '0' && each <= '9') || "+-.eE".indexOf(each) >= 0;
    }
    try {
      return plain ? Double.parseDouble(value) : Double.NaN;
    } catch (NumberFormatException e) {
      return Double.NaN;
    }
  }

  /** Returns the integer of an attribute; 0, and a problem, if it is none. */
  public int integer(String attribute) {
    String value = value(attribute);
    if (value == null) {
      missing(attribute);
      return 0;
    }
    try {
      return Integer.parseInt(value.strip());
    } catch (NumberFormatException e) {
      problems.add(
          XmlRules.NUMBER,
          at(attribute),
          "`" + attribute + "` is `" + shortened(value) + "`, which is no integer.",
          "Write an integer, such as `-1`.");
      return 0;
    }
  }

  /**
   * Returns what an attribute's value stands for. If there is no such attribute, or with a problem
   * if the value is not allowed, that is the first of what is allowed.
   *
   * @param spelling of each value that is allowed; letter case does not matter
   */
  public <T> T choice(String attribute, List<T> allowed, Function<T, String> spelling) {
    String value = value(attribute);
    if (value == null) {
      return allowed.get(0);
    }
    for (T each : allowed) {
      if (spelling.apply(each).equalsIgnoreCase(value.strip())) {
        return each;
      }
    }
    problems.add(
        XmlRules.VALUE,
        at(attribute),
        "`" + attribute + "` is `" + shortened(value) + "`, which OpenDRIVE does not know here.",
        "Write one of "
            + allowed.stream()
                .map(v -> "`" + spelling.apply(v) + "`")
                .collect(Collectors.joining(", "))
            + ".");
    return allowed.get(0);
  }

  private static String shortened(String value) {
    return value.length() <= 40 ? value : value.substring(0, 40) + "...";
  }

  /** Returns the place of the element, with its path. */
  public SourceLocation location() {
    return place().location();
  }

  /** Returns the place of the element, which keeps no element in memory. */
  public Place place() {
    return new Place(source, offset, path());
  }

  /** Returns the place of an attribute; that of the element if it has no such attribute. */
  public SourceLocation at(String attribute) {
    return source.at(XmlEvents.attribute(source, offset, attribute)).withElement(path());
  }

  /** Returns the names of the elements from the root, with what identifies each. */
  private String path() {
    String own = name;
    for (String key : IDENTIFYING) {
      String value = value(key);
      if (value != null) {
        own = name + "[" + key + "=" + shortened(value) + "]";
        break;
      }
    }
    return parent == null ? own : parent.path() + "/" + own;
  }
}
