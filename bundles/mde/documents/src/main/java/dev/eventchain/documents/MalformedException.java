package dev.eventchain.documents;

/** Thrown for a text that is not a document. The message is a whole sentence for users. */
final class MalformedException extends Exception {

  private static final long serialVersionUID = 1L;

  private final int offset;

  MalformedException(String message, int offset) {
    super(message);
    this.offset = offset;
  }

  /** Returns the offset in the text; negative if the whole text is concerned. */
  int offset() {
    return offset;
  }
}
