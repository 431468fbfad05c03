package dev.eventchain.m2t;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.output.OutputFolder;
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
 * @param traced whether the result says where each line comes from
 */
public record GenerationContext(
    Function<EObject, SourceLocation> locator,
    Function<String, Optional<byte[]>> earlier,
    Map<String, String> properties,
    boolean traced) {

  /** Nothing known but where elements stand: an empty output folder, no properties. */
  public static GenerationContext of(Function<EObject, SourceLocation> locator) {
    return new GenerationContext(locator, name -> Optional.empty(), Map.of(), false);
  }

  /** The same with the files of an output folder. */
  public GenerationContext withEarlier(Function<String, Optional<byte[]>> newEarlier) {
    return new GenerationContext(locator, newEarlier, properties, traced);
  }

  /** The same with other properties. */
  public GenerationContext withProperties(Map<String, String> newProperties) {
    return new GenerationContext(locator, earlier, Map.copyOf(newProperties), traced);
  }

  /** The same, and the result says which template lines and elements made which lines. */
  public GenerationContext withTrace() {
    return new GenerationContext(locator, earlier, properties, true);
  }
}
