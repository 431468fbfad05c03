package dev.eventchain.dds;

/** The sides of a topic. */
enum Side {
  WRITER("writer"),
  READER("reader");

  private final String word;

  Side(String word) {
    this.word = word;
  }

  /** Returns the word for an endpoint on this side. */
  String word() {
    return word;
  }
}
