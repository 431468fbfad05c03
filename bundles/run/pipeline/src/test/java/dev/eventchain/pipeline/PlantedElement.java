package dev.eventchain.pipeline;

import java.util.ArrayList;
import java.util.List;

/** An element of a planted model, which starts on its own line. */
final class PlantedElement {

  /** A reference to another element; {@code more} is the text after it. */
  private record Link(String feature, PlantedElement to, String more) {}

  private final PlantedMetamodel.Type type;
  private final StringBuilder attributes = new StringBuilder();
  private final List<Link> links = new ArrayList<>();
  private final List<PlantedElement> parts = new ArrayList<>();
  private final List<String> partFeatures = new ArrayList<>();
  private final List<String> expected = new ArrayList<>();
  private String name;
  private String file;

  PlantedElement(PlantedMetamodel.Type type) {
    this.type = type;
  }

  PlantedMetamodel.Type type() {
    return type;
  }

  PlantedElement with(String feature, Object value) {
    attributes.append(" %s=\"%s\"".formatted(feature, value));
    return this;
  }

  PlantedElement to(String feature, PlantedElement target) {
    links.add(new Link(feature, target, ""));
    return this;
  }

  PlantedElement to(String feature, List<PlantedElement> targets) {
    targets.forEach(each -> to(feature, each));
    return this;
  }

  /** Returns a value as its own element, as several in one attribute cannot be. */
  PlantedElement value(String feature, String value) {
    links.add(new Link(feature, null, value));
    return this;
  }

  PlantedElement part(String feature, PlantedElement part) {
    partFeatures.add(feature);
    parts.add(part);
    return this;
  }

  /** Returns the rule or identifier of an expected finding; empty if there is none. */
  PlantedElement expect(String finding) {
    if (!finding.isEmpty()) {
      expected.add(finding);
    }
    return this;
  }

  /** Locates this element and its parts, for references of others. */
  void place(String inFile, String prefix) {
    file = inFile;
    name = prefix;
    for (int i = 0; i < parts.size(); i++) {
      parts.get(i).place(inFile, prefix + "_" + i);
    }
  }

  /** Adds this element to the lines of its file, and its findings to the expected ones. */
  void write(String feature, List<String> lines, List<String> findings) {
    int line = lines.size() + 1;
    expected.forEach(each -> findings.add(file + ":" + line + " " + each));
    StringBuilder text = new StringBuilder();
    text.append("<%s xsi:type=\"%s\" name=\"%s\"".formatted(feature, type.inXmi(), name));
    text.append(attributes).append('>');
    for (Link link : links) {
      String tag = link.feature();
      text.append(
          link.to() == null
              ? "<%s>%s</%s>".formatted(tag, link.more(), tag)
              : "<%s xsi:type=\"%s\" href=\"%s\"/>"
                  .formatted(tag, link.to().type.inXmi(), link.to().uriFrom(file)));
    }
    lines.add(text.toString());
    for (int i = 0; i < parts.size(); i++) {
      parts.get(i).write(partFeatures.get(i), lines, findings);
    }
    lines.add("</" + feature + ">");
  }

  private String uriFrom(String other) {
    return (file.equals(other) ? "" : file) + "#" + name;
  }
}
