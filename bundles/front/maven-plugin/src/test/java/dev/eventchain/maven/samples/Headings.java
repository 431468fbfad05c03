package dev.eventchain.maven.samples;

/** What the template of the sample {@code generate} calls. */
public final class Headings {

  private Headings() {}

  /** A heading as a sentence. */
  public static String sentence(String heading) {
    return heading + ".";
  }
}
