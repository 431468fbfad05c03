package dev.eventchain.llm.chat;

/**
 * Identity of the requested model, independent of the source of its answers: replay finds a
 * recording made by hand-off.
 *
 * @param provider the service of the model
 * @param name the provider's name for it; may contain slashes
 */
public record ModelName(String provider, String name) {
  public static final String PERSON = "handoff";

  /** Parses {@code provider/name}; without a provider, a person gives the answers. */
  public static ModelName parse(String text) {
    int slash = text.indexOf('/');
    String provider = slash < 0 ? PERSON : text.substring(0, slash);
    String name = text.substring(slash + 1);
    if (provider.isBlank() || name.isBlank()) {
      throw new IllegalArgumentException("'" + text + "' is not the name of a model.");
    }
    return new ModelName(provider, name);
  }

  /** Returns the name as the user writes it. */
  @Override
  public String toString() {
    return provider.equals(PERSON) ? name : provider + "/" + name;
  }

  /** Returns the name in the form for file names. */
  public String inFileName() {
    String safe = name.replaceAll("[^A-Za-z0-9._-]", "_");
    return safe.startsWith(".") ? "_" + safe.substring(1) : safe;
  }
}
