package dev.eventchain.workspace;

/** A file that does not have the format that it should have; the message is a clause about it. */
final class MalformedFileException extends Exception {

  private static final long serialVersionUID = 1L;

  MalformedFileException(String message) {
    super(message);
  }
}
