package dev.eventchain.jsonmodels;

/** Names in messages to people. */
public final class Names {

  private Names() {}

  /** Returns a name without line breaks and control characters of terminals. */
  public static String printable(String name) {
    return name.replaceAll("\\p{Cntrl}", "\uFFFD");
  }
}
