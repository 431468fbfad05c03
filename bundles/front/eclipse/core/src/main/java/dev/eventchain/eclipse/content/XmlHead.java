package dev.eventchain.eclipse.content;

import java.util.HashMap;
import java.util.Map;
import java.util.function.Predicate;

/** The first start tags of an XML text, which may be cut off. */
final class XmlHead {

  private static final String NAMESPACE = "http://eventchain.dev/eventchain/1.0";

  /** Common prefix of the namespaces of all versions. */
  private static final String OURS = "http://eventchain.dev/";

  private static final String ROOT = "EventChain";

  /** Common prefixes of the namespaces of XMI 1.x and 2.x. */
  private static final String[] XMI = {
    "http://www.omg.org/XMI", "http://www.omg.org/spec/XMI", "http://schema.omg.org/spec/XMI"
  };

  /** A start tag with the namespaces in scope. */
  private record Tag(String name, Map<String, String> namespaces, boolean isEmpty) {

    boolean isEventChain() {
      return localName().equals(ROOT) && NAMESPACE.equals(namespace());
    }

    boolean isOfAnyVersion() {
      String namespace = namespace();
      return namespace != null && namespace.startsWith(OURS);
    }

    boolean isXmi() {
      String namespace = namespace();
      for (String beginning : XMI) {
        if (namespace != null && namespace.startsWith(beginning)) {
          return localName().equals("XMI");
        }
      }
      return false;
    }

    private String localName() {
      return name.substring(name.indexOf(':') + 1);
    }

    private String namespace() {
      return namespaces.get(name.contains(":") ? name.substring(0, name.indexOf(':')) : "");
    }
  }

  private final String text;
  private int at;

  XmlHead(String text) {
    this.text = text;
  }

  /** Returns whether the root element is an event chain, or an XMI root that contains one. */
  boolean isEventChain() {
    return hasRoot(Tag::isEventChain);
  }

  /** Returns whether the root element, or one in an XMI root, is of any version of ours. */
  boolean isOfAnyVersion() {
    return hasRoot(Tag::isOfAnyVersion);
  }

  private boolean hasRoot(Predicate<Tag> kind) {
    Tag root = nextTag(Map.of());
    if (root == null || !root.isXmi() || root.isEmpty()) {
      return root != null && kind.test(root);
    }
    int depth = 0;
    while (skipToMarkup()) {
      if (text.startsWith("</", at)) {
        depth--;
        at = after(">", at);
      } else {
        Tag tag = nextTag(root.namespaces());
        if (tag == null || depth == 0 && kind.test(tag)) {
          return tag != null;
        }
        depth += tag.isEmpty() ? 0 : 1;
      }
    }
    return false;
  }

  private boolean skipToMarkup() {
    int next = text.indexOf('<', at);
    at = next < 0 ? text.length() : next;
    return next >= 0;
  }

  /** Returns the next start tag if only comments and the like precede it; else null. */
  private Tag nextTag(Map<String, String> outer) {
    while (true) {
      skipSpace();
      if (text.startsWith("<?", at)) {
        at = after("?>", at);
      } else if (text.startsWith("<!--", at)) {
        at = after("-->", at + 4);
      } else if (text.startsWith("<![CDATA[", at)) {
        at = after("]]>", at);
      } else if (text.startsWith("<!", at)) {
        skipDeclaration();
      } else if (text.startsWith("<", at)) {
        at++;
        return tag(outer);
      } else {
        return null;
      }
    }
  }

  /** Skips a document type declaration. */
  private void skipDeclaration() {
    int depth = 0;
    do {
      if (text.startsWith("<!--", at)) {
        at = after("-->", at + 4);
        continue;
      }
      char c = text.charAt(at);
      if (c == '"' || c == '\'') {
        at = after(String.valueOf(c), at + 1);
        continue;
      }
      depth += c == '<' ? 1 : c == '>' ? -1 : 0;
      at++;
    } while (depth > 0 && at < text.length());
  }

  private Tag tag(Map<String, String> outer) {
    Map<String, String> namespaces = new HashMap<>(outer);
    String name = name();
    while (at < text.length()) {
      skipSpace();
      String attribute = name();
      skipSpace();
      if (!text.startsWith("=", at)) {
        boolean isEmpty = text.startsWith("/>", at);
        boolean ends = attribute.isEmpty() && (isEmpty || text.startsWith(">", at));
        at = after(">", at);
        return ends && !name.isEmpty() ? new Tag(name, namespaces, isEmpty) : null;
      }
      at++;
      skipSpace();
      String value = value();
      if (attribute.equals("xmlns") || attribute.startsWith("xmlns:")) {
        namespaces.put(attribute.substring(Math.min(6, attribute.length())), value);
      }
    }
    return null;
  }

  private String name() {
    int start = at;
    while (at < text.length()
        && !isSpace(text.charAt(at))
        && "=/><\"'".indexOf(text.charAt(at)) < 0) {
      at++;
    }
    return text.substring(start, at);
  }

  private String value() {
    if (at >= text.length() || text.charAt(at) != '"' && text.charAt(at) != '\'') {
      at = text.length();
      return "";
    }
    int start = at + 1;
    at = after(text.substring(at, start), start);
    return text.substring(start, Math.max(start, at - 1));
  }

  private void skipSpace() {
    while (at < text.length() && isSpace(text.charAt(at))) {
      at++;
    }
  }

  private static boolean isSpace(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
  }

  /** Returns the offset after the next occurrence of a text; the end if there is none. */
  private int after(String what, int from) {
    int found = text.indexOf(what, from);
    return found < 0 ? text.length() : found + what.length();
  }
}
