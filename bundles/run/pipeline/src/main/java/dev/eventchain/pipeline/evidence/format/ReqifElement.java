package dev.eventchain.pipeline.evidence.format;

import dev.eventchain.diagnostics.FileRules;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.XmlElement;
import java.util.Optional;
import java.util.stream.Stream;

/** An element of a ReqIF document, whose names have any prefix, with its place in the text. */
record ReqifElement(XmlElement element) {

  /** Returns the root of a text that is well-formed, without a document type declaration. */
  static ReqifElement root(SourceText text) {
    return new ReqifElement(XmlElement.parse(text, FileRules.UNREADABLE));
  }

  /** Returns its name without prefix. */
  String name() {
    return element.name().substring(prefix().length());
  }

  /** Returns its prefix with the colon; empty if there is none. */
  String prefix() {
    return element.name().substring(0, element.name().indexOf(':') + 1);
  }

  int start() {
    return element.start();
  }

  /** Returns where its start tag has ended. */
  int content() {
    return element.contentStart();
  }

  /** Returns where its end tag begins; where the tag has ended, if it is written as one. */
  int contentEnd() {
    return element.contentEnd();
  }

  int end() {
    return element.end();
  }

  /** Returns whether it is written as one tag. */
  boolean isOneTag() {
    return element.isOneTag();
  }

  /** Returns an attribute; empty if it is missing. */
  String attribute(String name) {
    return element.attribute(name).orElse("");
  }

  /** Returns its text, if it has no children. */
  String text() {
    return element.text();
  }

  /** Returns the first child of a name. */
  Optional<ReqifElement> child(String wanted) {
    return children().filter(each -> each.name().equals(wanted)).findFirst();
  }

  private Stream<ReqifElement> children() {
    return element.children().stream().map(ReqifElement::new);
  }

  /** Returns itself and all elements in it with a name, in their order. */
  Stream<ReqifElement> all(String wanted) {
    Stream<ReqifElement> below = children().flatMap(each -> each.all(wanted));
    return name().equals(wanted) ? Stream.concat(Stream.of(this), below) : below;
  }
}
