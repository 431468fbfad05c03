package dev.eventchain.m2t;

import dev.eventchain.diagnostics.SourceLocation;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.eclipse.emf.ecore.EObject;

/**
 * What a generation knows besides the model.
 *
 * @param locator where a model element stands, for findings
 * @param earlier the content of a file of the output folder, usually {@link OutputFolder#read};
 *     needed for protected areas to survive
 * @param properties what {@code getProperty('key')} gives in a template
 */
public record GenerationContext(
    Function<EObject, SourceLocation> locator,
    Function<String, Optional<byte[]>> earlier,
    Map<String, String> properties) {

  /** Nothing known but where elements stand: an empty output folder, no properties. */
  public static GenerationContext of(Function<EObject, SourceLocation> locator) {
    return new GenerationContext(locator, name -> Optional.empty(), Map.of());
  }

  /** The same with the files of an output folder. */
  public GenerationContext withEarlier(Function<String, Optional<byte[]>> newEarlier) {
    return new GenerationContext(locator, newEarlier, properties);
  }

  /** The same with other properties. */
  public GenerationContext withProperties(Map<String, String> newProperties) {
    return new GenerationContext(locator, earlier, Map.copyOf(newProperties));
  }
}
