package dev.eventchain.description;

/** Names of the files and folders in a software base, relative to its folder. */
public final class SoftwareBaseNames {

  /** The descriptions of existing components. */
  public static final String COMPONENTS = "components.json";

  /** The signals of the vehicle. */
  public static final String SIGNALS = "signals.json";

  /** The open questions about the existing software. */
  public static final String QUESTIONS = "questions.json";

  /** The folder of message definitions. */
  public static final String MESSAGES = "msg";

  private SoftwareBaseNames() {}
}
