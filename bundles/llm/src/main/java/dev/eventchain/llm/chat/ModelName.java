package dev.eventchain.llm.chat;

/**
 * Which model is asked, apart from the way its answers come here: a recording made by hand-off is
 * found again by replay.
 *
 * @param provider who serves the model
 * @param name the provider's name for it; may hold slashes
 */
public record ModelName(String provider, String name) {
  public static final String PERSON = "handoff";

  /** Reads {@code provider/name}; without a provider, answers come through a person. */
  public static ModelName parse(String text) {
    int slash = text.indexOf('/');
    String provider = slash < 0 ? PERSON : text.substring(0, slash);
    String name = text.substring(slash + 1);
    if (provider.isBlank() || name.isBlank()) {
      throw new IllegalArgumentException("'" + text + "' is not the name of a model.");
    }
    return new ModelName(provider, name);
  }

  /** As people write it. */
  @Override
  public String toString() {
    return provider.equals(PERSON) ? name : provider + "/" + name;
  }

  /** The name as part of a file name. */
  public String inFileName() {
    String safe = name.replaceAll("[^A-Za-z0-9._-]", "_");
    return safe.startsWith(".") ? "_" + safe.substring(1) : safe;
  }
}
