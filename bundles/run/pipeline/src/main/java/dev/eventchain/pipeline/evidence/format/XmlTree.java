package dev.eventchain.pipeline.evidence.format;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The elements of a well-formed document, each with its place in the text: the text can be changed
 * at these places, and stays what it is elsewhere.
 */
final class XmlTree {

  /** An element, which is known completely once it has ended. */
  static final class Element {
    private final String name;
    private final String prefix;
    private final int start;
    private final int content;
    private final List<Element> children = new ArrayList<>();
    private int contentEnd;
    private int end;

    private Element(String qualifiedName, int start, int content) {
      int colon = qualifiedName.indexOf(':') + 1;
      this.name = qualifiedName.substring(colon);
      this.prefix = qualifiedName.substring(0, colon);
      this.start = start;
      this.content = content;
    }

    /** Returns its name without prefix. */
    String name() {
      return name;
    }

    /** Returns its prefix with the colon; empty if there is none. */
    String prefix() {
      return prefix;
    }

    /** Returns where its start tag begins. */
    int start() {
      return start;
    }

    /** Returns where its start tag has ended. */
    int content() {
      return content;
    }

    /** Returns where its end tag begins; where the tag has ended, if it is written as one. */
    int contentEnd() {
      return contentEnd;
    }

    int end() {
      return end;
    }

    /** Returns whether it is written as one tag. */
    boolean isEmptyTag() {
      return contentEnd == end;
    }

    Optional<Element> child(String child) {
      return children.stream().filter(each -> each.name.equals(child)).findFirst();
    }

    /** Returns itself and all elements in it with a name, in their order. */
    Stream<Element> all(String wanted) {
      Stream<Element> below = children.stream().flatMap(each -> each.all(wanted));
      return name.equals(wanted) ? Stream.concat(Stream.of(this), below) : below;
    }
  }

  private static final String NAME = "[^\\s/>\"'=<]+";
  private static final Pattern TAG =
      Pattern.compile(
          "<!--.*?-->|<!\\[CDATA\\[.*?\\]\\]>|<\\?.*?\\?>"
              + "|<(/?)("
              + NAME
              + ")(?:\"[^\"]*\"|'[^']*'|[^\"'>]++)*+>",
          Pattern.DOTALL);

  private final String text;
  private final Element root;

  private XmlTree(String text, Element root) {
    this.text = text;
    this.root = root;
  }

  /**
   * Returns the elements of a document.
   *
   * @param text well-formed, without a document type declaration
   */
  static XmlTree of(String text) {
    Deque<Element> open = new ArrayDeque<>();
    Element document = new Element("", 0, 0);
    open.push(document);
    Matcher tag = TAG.matcher(text);
    while (tag.find()) {
      if (tag.group(2) == null) {
        continue;
      }
      if (!tag.group(1).isEmpty()) {
        end(open.pop(), tag.start(), tag.end());
        continue;
      }
      Element element = new Element(tag.group(2), tag.start(), tag.end());
      open.element().children.add(element);
      if (text.charAt(tag.end() - 2) == '/') {
        end(element, tag.end(), tag.end());
      } else {
        open.push(element);
      }
    }
    return new XmlTree(text, document.children.get(0));
  }

  private static void end(Element element, int contentEnd, int end) {
    element.contentEnd = contentEnd;
    element.end = end;
  }

  Element root() {
    return root;
  }

  /** Returns an attribute of an element, without references to characters; empty if missing. */
  String attribute(Element element, String name) {
    String tag = text.substring(element.start(), element.content());
    Matcher found =
        Pattern.compile("\\s" + Pattern.quote(name) + "\\s*=\\s*(?:\"([^\"]*)\"|'([^']*)')")
            .matcher(tag);
    if (!found.find()) {
      return "";
    }
    return plain(found.group(1) != null ? found.group(1) : found.group(2));
  }

  /** Returns the text of an element, without tags. */
  String text(Element element) {
    return element.isEmptyTag()
        ? ""
        : plain(
            text.substring(element.content(), element.contentEnd())
                .replaceAll("<[^>]*>", "")
                .strip());
  }

  private static String plain(String escaped) {
    return escaped
        .replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&quot;", "\"")
        .replace("&apos;", "'")
        .replace("&amp;", "&");
  }
}
