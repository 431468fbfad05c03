package dev.eventchain.pipeline.evidence.format;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.Xml;
import dev.eventchain.pipeline.evidence.Evidence;
import dev.eventchain.pipeline.evidence.Evidence.Requirement;
import dev.eventchain.pipeline.evidence.Evidence.Test;
import dev.eventchain.pipeline.evidence.Evidence.Verdict;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Adds the verdict on each requirement to a ReqIF document, as attributes {@code
 * Eventchain.Verdict} (an enumeration), {@code Eventchain.Strength} and {@code
 * Eventchain.Evidence}. What an earlier report has added is replaced; everything else stays as it
 * is, byte for byte.
 */
final class ReqifVerdicts {

  /** Beginning of all identifiers that are added. */
  private static final String OURS = "eventchain-";

  private static final String DATATYPES =
      """
      <DATATYPE-DEFINITION-ENUMERATION IDENTIFIER="eventchain-verdict" LAST-CHANGE="%1$s" LONG-NAME="Eventchain verdict">
        <SPECIFIED-VALUES>
      %2$s  </SPECIFIED-VALUES>
      </DATATYPE-DEFINITION-ENUMERATION>
      <DATATYPE-DEFINITION-STRING IDENTIFIER="eventchain-string" LAST-CHANGE="%1$s" LONG-NAME="Eventchain text" MAX-LENGTH="32000"/>
      """;

  private static final String ENUM_VALUE =
      """
          <ENUM-VALUE IDENTIFIER="eventchain-verdict-%2$s" LAST-CHANGE="%1$s" LONG-NAME="%4$s">
            <PROPERTIES>
              <EMBEDDED-VALUE KEY="%3$s" OTHER-CONTENT=""/>
            </PROPERTIES>
          </ENUM-VALUE>
      """;

  private static final String DEFINITIONS =
      """
      <ATTRIBUTE-DEFINITION-ENUMERATION IDENTIFIER="eventchain-verdict-of-%2$s" LAST-CHANGE="%1$s" LONG-NAME="Eventchain.Verdict" MULTI-VALUED="false">
        <TYPE>
          <DATATYPE-DEFINITION-ENUMERATION-REF>eventchain-verdict</DATATYPE-DEFINITION-ENUMERATION-REF>
        </TYPE>
      </ATTRIBUTE-DEFINITION-ENUMERATION>
      <ATTRIBUTE-DEFINITION-STRING IDENTIFIER="eventchain-strength-of-%2$s" LAST-CHANGE="%1$s" LONG-NAME="Eventchain.Strength">
        <TYPE>
          <DATATYPE-DEFINITION-STRING-REF>eventchain-string</DATATYPE-DEFINITION-STRING-REF>
        </TYPE>
      </ATTRIBUTE-DEFINITION-STRING>
      <ATTRIBUTE-DEFINITION-STRING IDENTIFIER="eventchain-evidence-of-%2$s" LAST-CHANGE="%1$s" LONG-NAME="Eventchain.Evidence">
        <TYPE>
          <DATATYPE-DEFINITION-STRING-REF>eventchain-string</DATATYPE-DEFINITION-STRING-REF>
        </TYPE>
      </ATTRIBUTE-DEFINITION-STRING>
      """;

  private static final String VERDICT_VALUE =
      """
      <ATTRIBUTE-VALUE-ENUMERATION>
        <VALUES>
          <ENUM-VALUE-REF>eventchain-verdict-%1$s</ENUM-VALUE-REF>
        </VALUES>
        <DEFINITION>
          <ATTRIBUTE-DEFINITION-ENUMERATION-REF>eventchain-verdict-of-%2$s</ATTRIBUTE-DEFINITION-ENUMERATION-REF>
        </DEFINITION>
      </ATTRIBUTE-VALUE-ENUMERATION>
      """;

  private static final String STRING_VALUE =
      """
      <ATTRIBUTE-VALUE-STRING THE-VALUE="%3$s">
        <DEFINITION>
          <ATTRIBUTE-DEFINITION-STRING-REF>eventchain-%1$s-of-%2$s</ATTRIBUTE-DEFINITION-STRING-REF>
        </DEFINITION>
      </ATTRIBUTE-VALUE-STRING>
      """;

  private static final int LONGEST = 32_000;

  private final Evidence evidence;
  private final String source;

  /** The byte order mark before the source; empty if there is none. */
  private final String mark;

  private final ReqifElement content;
  private final Map<String, Integer> types = new HashMap<>();

  /** Texts that replace parts of the source, by where these begin. */
  private final NavigableMap<Integer, Change> changes = new TreeMap<>();

  private record Change(int end, String text) {}

  private ReqifVerdicts(String document, Evidence evidence) {
    SourceText text = SourceText.of("", document);
    this.source = text.text();
    this.mark = document.substring(0, document.length() - source.length());
    this.evidence = evidence;
    ReqifElement root = ReqifElement.root(text);
    this.content = root.all("REQ-IF-CONTENT").findFirst().orElse(root);
  }

  /**
   * Returns the requirements of which a document has no object.
   *
   * @param source a well-formed ReqIF document
   */
  static List<String> missing(String source, Evidence evidence) {
    Map<String, ReqifElement> objects = new ReqifVerdicts(source, evidence).objects();
    return evidence.requirements().stream()
        .map(Requirement::id)
        .filter(id -> !objects.containsKey(id))
        .toList();
  }

  /**
   * Returns a document with the verdicts.
   *
   * @param source a well-formed ReqIF document
   */
  static String add(String source, Evidence evidence) {
    return new ReqifVerdicts(source, evidence).add();
  }

  private String add() {
    removeEarlier();
    StringBuilder values = new StringBuilder();
    int number = 0;
    for (Verdict verdict : Verdict.values()) {
      values.append(
          ENUM_VALUE.formatted(ReqifDocument.TIME, key(verdict), number++, verdict.words()));
    }
    insert(content, "DATATYPES", DATATYPES.formatted(ReqifDocument.TIME, values));
    Map<String, ReqifElement> objects = objects();
    for (Requirement requirement : evidence.requirements()) {
      Optional.ofNullable(objects.get(requirement.id()))
          .ifPresent(object -> insert(object, "VALUES", values(requirement, typeOf(object))));
    }
    content
        .all("SPEC-OBJECT-TYPE")
        .filter(each -> types.containsKey(each.attribute("IDENTIFIER")))
        .forEach(this::define);
    return changed();
  }

  /** Returns the end of the identifier of a verdict. */
  private static String key(Verdict verdict) {
    return verdict.words().replace(' ', '-');
  }

  private void define(ReqifElement type) {
    int number = types.get(type.attribute("IDENTIFIER"));
    insert(type, "SPEC-ATTRIBUTES", DEFINITIONS.formatted(ReqifDocument.TIME, number));
  }

  /** Returns the number of an object's type, from 1. */
  private int typeOf(ReqifElement object) {
    String type = object.all("SPEC-OBJECT-TYPE-REF").map(ReqifElement::text).findFirst().orElse("");
    Integer known = types.putIfAbsent(type, types.size() + 1);
    return known == null ? types.size() : known;
  }

  private String values(Requirement requirement, int type) {
    Stream<String> tests =
        evidence.tests().stream()
            .filter(each -> each.about(requirement.id()).isPresent())
            .map(each -> item(each, requirement.id()));
    Stream<String> reason = requirement.reason().map(it -> requirement.words()).stream();
    String all = Stream.concat(reason, tests).collect(Collectors.joining("; "));
    return VERDICT_VALUE.formatted(key(requirement.verdict()), type)
        + requirement.strength().map(it -> string("strength", type, it.words())).orElse("")
        + (all.isEmpty() ? "" : string("evidence", type, all));
  }

  private static String item(Test test, String requirement) {
    return test.fullName() + " " + test.about(requirement).orElseThrow().words();
  }

  private static String string(String kind, int type, String text) {
    String shown = text.length() > LONGEST ? text.substring(0, LONGEST - 3) + "..." : text;
    return STRING_VALUE.formatted(kind, type, Xml.attribute(shown));
  }

  /** Returns the object of each requirement that has one. */
  private Map<String, ReqifElement> objects() {
    List<String> ids =
        content
            .all("ATTRIBUTE-DEFINITION-STRING")
            .filter(each -> each.attribute("LONG-NAME").equals("ReqIF.ForeignID"))
            .map(each -> each.attribute("IDENTIFIER"))
            .toList();
    Map<String, ReqifElement> objects = new LinkedHashMap<>();
    content.all("SPEC-OBJECT").forEach(each -> objects.put(id(each, ids), each));
    return objects;
  }

  /** Returns the id of an object: that of the tool where it was written, else its identifier. */
  private String id(ReqifElement object, List<String> ids) {
    return object
        .all("ATTRIBUTE-VALUE-STRING")
        .filter(
            each ->
                each.all("ATTRIBUTE-DEFINITION-STRING-REF")
                    .anyMatch(ref -> ids.contains(ref.text())))
        .map(each -> each.attribute("THE-VALUE"))
        .findFirst()
        .orElseGet(() -> object.attribute("IDENTIFIER"));
  }

  /** Removes what an earlier report has added. */
  private void removeEarlier() {
    List<ReqifElement> added = new ArrayList<>();
    for (String name :
        List.of(
            "DATATYPE-DEFINITION-ENUMERATION",
            "DATATYPE-DEFINITION-STRING",
            "ATTRIBUTE-DEFINITION-ENUMERATION",
            "ATTRIBUTE-DEFINITION-STRING")) {
      content
          .all(name)
          .filter(each -> each.attribute("IDENTIFIER").startsWith(OURS))
          .forEach(added::add);
    }
    for (String kind : List.of("ENUMERATION", "STRING")) {
      content
          .all("ATTRIBUTE-VALUE-" + kind)
          .filter(
              each ->
                  each.all("ATTRIBUTE-DEFINITION-" + kind + "-REF")
                      .anyMatch(ref -> ref.text().startsWith(OURS)))
          .forEach(added::add);
    }
    added.forEach(each -> changes.put(lineStart(each.start()), new Change(each.end(), "")));
  }

  /** Returns where a line break before a place begins, if there is only white space between. */
  private int lineStart(int place) {
    int start = place;
    while (start > 0 && (source.charAt(start - 1) == ' ' || source.charAt(start - 1) == '\t')) {
      start--;
    }
    if (start > 0 && source.charAt(start - 1) == '\n') {
      start--;
      return start > 0 && source.charAt(start - 1) == '\r' ? start - 1 : start;
    }
    return place;
  }

  /** Inserts elements at the end of a child, which is made if the parent has none. */
  private void insert(ReqifElement parent, String child, String elements) {
    Optional<ReqifElement> into = parent.child(child);
    if (into.isEmpty()) {
      String both = "<" + child + ">\n" + elements.indent(2) + "</" + child + ">\n";
      append(parent, both);
    } else {
      append(into.get(), elements);
    }
  }

  private void append(ReqifElement parent, String elements) {
    String end = source.contains("\r\n") ? "\r\n" : "\n";
    int line = lineStart(parent.start());
    String margin =
        line == parent.start()
            ? ""
            : source.substring(line, parent.start()).replaceAll("[\r\n]", "");
    String lines =
        elements
            .replaceAll("<(/?)", "<$1" + parent.prefix())
            .lines()
            .map(each -> end + margin + "  " + each)
            .collect(Collectors.joining());
    if (parent.isOneTag()) {
      String name = parent.prefix() + parent.name();
      String tag = source.substring(parent.start(), parent.content());
      String open = tag.substring(0, tag.lastIndexOf('/')).stripTrailing() + ">";
      change(parent.start(), parent.end(), open + lines + end + margin + "</" + name + ">");
    } else {
      int place = lineStart(parent.contentEnd());
      boolean alone = place < parent.contentEnd();
      change(place, place, alone ? lines : lines + end + margin);
    }
  }

  private void change(int start, int end, String text) {
    Change removed = changes.get(start);
    changes.put(
        start,
        removed == null
            ? new Change(end, text)
            : new Change(Math.max(end, removed.end()), text + removed.text()));
  }

  private String changed() {
    StringBuilder text = new StringBuilder(mark);
    int from = 0;
    for (Map.Entry<Integer, Change> change : changes.entrySet()) {
      text.append(source, from, change.getKey()).append(change.getValue().text());
      from = change.getValue().end();
    }
    return text.append(source.substring(from)).toString();
  }
}
