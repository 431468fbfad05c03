package dev.eventchain.openscenario.document;

import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.XmlElement;
import dev.eventchain.openscenario.vocabulary.AttributeType;
import dev.eventchain.openscenario.vocabulary.Content.Mismatch;
import dev.eventchain.openscenario.vocabulary.ElementType;
import dev.eventchain.openscenario.vocabulary.Version;
import dev.eventchain.openscenario.vocabulary.Vocabulary;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Holds elements against the vocabulary: names, presence and numbers of elements and attributes,
 * and values that are no parameters. What only a later version than the declared one has is read,
 * with a warning.
 */
final class StructureCheck {

  private final Version version;
  private final Findings findings;

  StructureCheck(Version version, Findings findings) {
    this.version = version;
    this.findings = findings;
  }

  /** Checks an element with everything in it. */
  void check(XmlElement element, ElementType type) {
    attributes(element, type);
    children(element, type);
    Map<String, String> types = type.children();
    for (XmlElement child : element.children()) {
      if (types.containsKey(child.name())) {
        check(child, Vocabulary.standard().element(types.get(child.name())));
      }
    }
  }

  private void attributes(XmlElement element, ElementType type) {
    element.attributes().forEach((name, value) -> attribute(element, type, name, value));
    for (AttributeType attribute : type.attributes().values()) {
      if (attribute.isRequired(version) && element.attribute(attribute.name()).isEmpty()) {
        String message = named(element) + " has no attribute `" + attribute.name() + "`.";
        boolean later = !attribute.isRequired(Version.LATEST);
        report(later, DocumentRules.ATTRIBUTE_MISSING, message, element.location(), "");
      }
    }
  }

  private void attribute(XmlElement element, ElementType type, String name, String value) {
    if (name.indexOf(':') >= 0) {
      return;
    }
    AttributeType attribute = type.attribute(name).orElse(null);
    boolean known = attribute != null && version.isSince(attribute.since());
    if (known && (value.startsWith("$") || AttributeValues.latest(attribute, value).isPresent())) {
      return;
    }
    SourceLocation place = element.location(name);
    String message = named(element) + " has no attribute named `" + name + "`.";
    if (attribute == null) {
      String hint = NearestName.hint(name, type.attributes().keySet());
      findings.add(DocumentRules.ATTRIBUTE_UNKNOWN, message, place, hint);
      return;
    }
    if (!version.isSince(attribute.since()) && version.isSince(type.since())) {
      report(true, DocumentRules.ATTRIBUTE_UNKNOWN, message, place, "");
    }
    if (!value.startsWith("$")) {
      AttributeValues.check(attribute, value, place, findings);
    }
  }

  private void children(XmlElement element, ElementType type) {
    Map<String, Integer> names = new LinkedHashMap<>();
    element.children().forEach(child -> names.merge(child.name(), 1, Integer::sum));
    List<Mismatch> declared = type.content(version).mismatches(names);
    if (declared.isEmpty()) {
      return;
    }
    List<Mismatch> latest = type.content(Version.LATEST).mismatches(names);
    List<Mismatch> lasting = new ArrayList<>(declared);
    lasting.retainAll(latest);
    boolean nothingLasts = lasting.isEmpty() && !latest.isEmpty();
    for (Mismatch mismatch : declared) {
      mismatch(element, type, mismatch, !nothingLasts && !lasting.contains(mismatch));
    }
  }

  private void mismatch(XmlElement element, ElementType type, Mismatch mismatch, boolean later) {
    List<XmlElement> there = element.children(mismatch.name());
    switch (mismatch.kind()) {
      case MISSING -> missing(element, mismatch.name(), there, later);
      case SURPLUS -> surplus(element, mismatch.name(), there, later);
      case UNKNOWN -> unknown(element, type, there.get(0), later);
    }
  }

  /** Reports a missing element; the name may be several ones of which one is missing. */
  private void missing(XmlElement element, String name, List<XmlElement> there, boolean later) {
    String what = "`" + name.replace(" or ", "` or `") + "`.";
    String message = there.isEmpty() ? " has no " + what : " has too few elements " + what;
    report(later, DocumentRules.ELEMENT_MISSING, named(element) + message, element.location(), "");
  }

  private void surplus(XmlElement element, String name, List<XmlElement> there, boolean later) {
    String message =
        there.size() == 1
            ? "Of `%s` and another element in %s, only one may be there."
            : "`%s` stands too often in %s.";
    report(
        later,
        DocumentRules.ELEMENT_SURPLUS,
        String.format(message, name, named(element)),
        there.get(there.size() - 1).location(),
        "Leave one out.");
  }

  private void unknown(XmlElement element, ElementType type, XmlElement child, boolean later) {
    Set<String> known = type.children().keySet();
    report(
        later,
        DocumentRules.ELEMENT_UNKNOWN,
        named(element) + " has no element named " + named(child) + " in it.",
        child.location(),
        known.isEmpty() ? "It has no elements in it." : NearestName.hint(child.name(), known));
  }

  private void report(boolean later, Rule rule, String message, SourceLocation place, String hint) {
    if (later) {
      findings.add(
          DocumentRules.NEWER,
          message.replaceFirst("\\.$", "")
              + " in version "
              + version
              + ", which the file declares.",
          place,
          "It is read as a later version says; declare that one as `revMinor`.");
    } else {
      findings.add(rule, message, place, hint);
    }
  }

  private static String named(XmlElement element) {
    return "`" + element.name() + "`";
  }
}
