package dev.eventchain.pipeline.evidence.format;

import dev.eventchain.diagnostics.Sha256;
import dev.eventchain.diagnostics.Xml;
import dev.eventchain.pipeline.evidence.Evidence;
import dev.eventchain.pipeline.evidence.Evidence.Requirement;
import java.util.stream.Collectors;

/**
 * A ReqIF 1.2 document with the requirements of a project that come from no such document: a
 * specification with one object for each. Identifiers depend on ids alone, so that a tool that has
 * imported an earlier one knows the objects again.
 */
final class ReqifDocument {

  /** The time of everything in it, since equal requirements give equal bytes. */
  static final String TIME = "1970-01-01T00:00:00Z";

  private static final String DOCUMENT =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <REQ-IF xmlns="http://www.omg.org/spec/ReqIF/20110401/reqif.xsd" xmlns:xhtml="http://www.w3.org/1999/xhtml">
        <THE-HEADER>
          <REQ-IF-HEADER IDENTIFIER="header">
            <CREATION-TIME>%1$s</CREATION-TIME>
            <REQ-IF-TOOL-ID>eventchain</REQ-IF-TOOL-ID>
            <REQ-IF-VERSION>1.0</REQ-IF-VERSION>
            <SOURCE-TOOL-ID>eventchain</SOURCE-TOOL-ID>
            <TITLE>%2$s</TITLE>
          </REQ-IF-HEADER>
        </THE-HEADER>
        <CORE-CONTENT>
          <REQ-IF-CONTENT>
            <DATATYPES>
              <DATATYPE-DEFINITION-STRING IDENTIFIER="string" LAST-CHANGE="%1$s" LONG-NAME="String" MAX-LENGTH="1000"/>
              <DATATYPE-DEFINITION-XHTML IDENTIFIER="xhtml" LAST-CHANGE="%1$s" LONG-NAME="XHTML"/>
            </DATATYPES>
            <SPEC-TYPES>
              <SPEC-OBJECT-TYPE IDENTIFIER="requirement" LAST-CHANGE="%1$s" LONG-NAME="Requirement">
                <SPEC-ATTRIBUTES>
                  <ATTRIBUTE-DEFINITION-STRING IDENTIFIER="id" LAST-CHANGE="%1$s" LONG-NAME="ReqIF.ForeignID">
                    <TYPE>
                      <DATATYPE-DEFINITION-STRING-REF>string</DATATYPE-DEFINITION-STRING-REF>
                    </TYPE>
                  </ATTRIBUTE-DEFINITION-STRING>
                  <ATTRIBUTE-DEFINITION-XHTML IDENTIFIER="text" LAST-CHANGE="%1$s" LONG-NAME="ReqIF.Text">
                    <TYPE>
                      <DATATYPE-DEFINITION-XHTML-REF>xhtml</DATATYPE-DEFINITION-XHTML-REF>
                    </TYPE>
                  </ATTRIBUTE-DEFINITION-XHTML>
                </SPEC-ATTRIBUTES>
              </SPEC-OBJECT-TYPE>
              <SPECIFICATION-TYPE IDENTIFIER="specification" LAST-CHANGE="%1$s" LONG-NAME="Specification"/>
            </SPEC-TYPES>
            <SPEC-OBJECTS>
      %3$s      </SPEC-OBJECTS>
            <SPECIFICATIONS>
              <SPECIFICATION IDENTIFIER="requirements" LAST-CHANGE="%1$s" LONG-NAME="%2$s">
                <TYPE>
                  <SPECIFICATION-TYPE-REF>specification</SPECIFICATION-TYPE-REF>
                </TYPE>
                <CHILDREN>
      %4$s          </CHILDREN>
              </SPECIFICATION>
            </SPECIFICATIONS>
          </REQ-IF-CONTENT>
        </CORE-CONTENT>
      </REQ-IF>
      """;

  private static final String OBJECT =
      """
              <SPEC-OBJECT IDENTIFIER="object-%2$s" LAST-CHANGE="%1$s">
                <VALUES>
                  <ATTRIBUTE-VALUE-STRING THE-VALUE="%3$s">
                    <DEFINITION>
                      <ATTRIBUTE-DEFINITION-STRING-REF>id</ATTRIBUTE-DEFINITION-STRING-REF>
                    </DEFINITION>
                  </ATTRIBUTE-VALUE-STRING>
                  <ATTRIBUTE-VALUE-XHTML>
                    <DEFINITION>
                      <ATTRIBUTE-DEFINITION-XHTML-REF>text</ATTRIBUTE-DEFINITION-XHTML-REF>
                    </DEFINITION>
                    <THE-VALUE>
                      <xhtml:div>%4$s</xhtml:div>
                    </THE-VALUE>
                  </ATTRIBUTE-VALUE-XHTML>
                </VALUES>
                <TYPE>
                  <SPEC-OBJECT-TYPE-REF>requirement</SPEC-OBJECT-TYPE-REF>
                </TYPE>
              </SPEC-OBJECT>
      """;

  private static final String PLACE =
      """
                  <SPEC-HIERARCHY IDENTIFIER="place-%2$s" LAST-CHANGE="%1$s">
                    <OBJECT>
                      <SPEC-OBJECT-REF>object-%2$s</SPEC-OBJECT-REF>
                    </OBJECT>
                  </SPEC-HIERARCHY>
      """;

  private ReqifDocument() {}

  static String of(Evidence evidence) {
    return DOCUMENT.formatted(
        TIME, Xml.attribute(evidence.title()), all(evidence, OBJECT), all(evidence, PLACE));
  }

  private static String all(Evidence evidence, String form) {
    return evidence.requirements().stream()
        .map(each -> one(each, form))
        .collect(Collectors.joining());
  }

  private static String one(Requirement requirement, String form) {
    return form.formatted(
        TIME, key(requirement.id()), Xml.attribute(requirement.id()), text(requirement.text()));
  }

  /** Returns a text in XHTML; several lines as paragraphs, since some readers drop line breaks. */
  private static String text(String text) {
    return text.contains("\n")
        ? text.lines()
            .map(line -> "<xhtml:p>" + escaped(line) + "</xhtml:p>")
            .collect(Collectors.joining())
        : escaped(text);
  }

  /** Returns a text as the Python package reqif writes it. */
  private static String escaped(String text) {
    return Xml.text(text).replace("\"", "&quot;");
  }

  /** Returns an id as the end of an XML name. */
  private static String key(String id) {
    return id.matches("[A-Za-z0-9_.-]+") ? id : Sha256.of(id).abbreviated();
  }
}
