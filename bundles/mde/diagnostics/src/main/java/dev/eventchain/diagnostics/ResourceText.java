package dev.eventchain.diagnostics;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/** Reader of texts that a bundle brings along beside its classes, such as a JSON Schema. */
public final class ResourceText {

  private ResourceText() {}

  /**
   * Returns a text in UTF-8.
   *
   * @param owner a class of the bundle that has the text
   * @param name its name beside the class, or with a slash from the root of the bundle
   * @throws IllegalArgumentException if there is none
   */
  public static String of(Class<?> owner, String name) {
    try (InputStream input = owner.getResourceAsStream(name)) {
      if (input == null) {
        throw new IllegalArgumentException(
            "there is no resource " + name + " of " + owner.getName());
      }
      return new String(input.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
