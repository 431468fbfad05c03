package dev.eventchain.diagnostics;

/** Escapes text for XML 1.0; characters that it cannot hold are replaced. */
public final class Xml {

  private Xml() {}

  /** Returns the content of an attribute in double quotes. */
  public static String attribute(String text) {
    return text(text).replace("\"", "&quot;").replace("\n", "&#10;").replace("\t", "&#9;");
  }

  /** Returns the content of an element. */
  public static String text(String text) {
    return Printable.clean(text)
        .replace('\uFFFE', '\uFFFD')
        .replace('\uFFFF', '\uFFFD')
        .replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;");
  }
}
