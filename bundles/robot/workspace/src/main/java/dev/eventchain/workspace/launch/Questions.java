package dev.eventchain.workspace.launch;

/** Receiver of questions about what launch files and files of parameters do not state. */
@FunctionalInterface
public interface Questions {

  /**
   * Receives a question.
   *
   * @param file the file that it is about, relative to the workspace
   * @param line counts from 1
   */
  void add(String text, String file, int line);
}
