package dev.eventchain.documents;

/** A text is not a document. The message is a whole sentence for people. */
final class MalformedException extends Exception {

  private static final long serialVersionUID = 1L;

  private final int offset;

  MalformedException(String message, int offset) {
    super(message);
    this.offset = offset;
  }

  /** Where in the text; below zero if it is about the whole. */
  int offset() {
    return offset;
  }
}
