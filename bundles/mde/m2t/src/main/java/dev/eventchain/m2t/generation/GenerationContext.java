package dev.eventchain.m2t.generation;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.output.OutputFolder;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EObject;

/**
 * What a generation knows in addition to the model.
 *
 * @param locator where a model element is, for findings
 * @param earlier the content of a file of the output folder, usually {@link OutputFolder#read};
 *     needed for protected areas to survive
 * @param properties what {@code getProperty('key')} gives in a template
 * @param propertyFiles the properties of files by the files' names, which {@code
 *     getProperty('name', 'key')} tells apart, in order
 * @param traits what else is wanted of the generation
 */
public record GenerationContext(
    Function<EObject, SourceLocation> locator,
    Function<String, Optional<byte[]>> earlier,
    Map<String, String> properties,
    Map<String, Map<String, String>> propertyFiles,
    Set<Trait> traits) {

  /** How a generation goes, other than usually. */
  public enum Trait {
    /** The result says which template lines and elements made which lines. */
    TRACED,

    /** What Acceleo continues after without failing is a warning, not an error. */
    LENIENT,

    /** There is no output folder: blocks of files can print only, and any other is an error. */
    PRINTED_ONLY
  }

  /** Takes a copy of the traits. */
  public GenerationContext {
    traits = Set.copyOf(traits);
  }

  /** Nothing known but where elements are: an empty output folder, no properties. */
  public static GenerationContext of(Function<EObject, SourceLocation> locator) {
    return new GenerationContext(locator, name -> Optional.empty(), Map.of(), Map.of(), Set.of());
  }

  /** The same with the files of an output folder. */
  public GenerationContext withEarlier(Function<String, Optional<byte[]>> newEarlier) {
    return new GenerationContext(locator, newEarlier, properties, propertyFiles, traits);
  }

  /** The same with other properties, which are in no file. */
  public GenerationContext withProperties(Map<String, String> newProperties) {
    return new GenerationContext(
        locator, earlier, Map.copyOf(newProperties), propertyFiles, traits);
  }

  /**
   * The same with other files of properties.
   *
   * @param newFiles by the files' names, in the order in which they are asked for a key
   */
  public GenerationContext withPropertyFiles(Map<String, Map<String, String>> newFiles) {
    Map<String, Map<String, String>> files =
        Collections.unmodifiableMap(new LinkedHashMap<>(newFiles));
    return new GenerationContext(locator, earlier, properties, files, traits);
  }

  /** The same with more traits. */
  public GenerationContext with(Set<Trait> others) {
    Set<Trait> more = new HashSet<>(traits);
    more.addAll(others);
    return new GenerationContext(locator, earlier, properties, propertyFiles, more);
  }

  /** The same, and the result says which template lines and elements made which lines. */
  public GenerationContext withTrace() {
    return with(Set.of(Trait.TRACED));
  }

  public boolean has(Trait trait) {
    return traits.contains(trait);
  }

  /** What {@code getProperty('key')} gives: what is in no file, else the first file that has it. */
  public Optional<String> property(String key) {
    return Stream.concat(Stream.of(properties), propertyFiles.values().stream())
        .flatMap(each -> Optional.ofNullable(each.get(key)).stream())
        .findFirst();
  }

  /**
   * What {@code getProperty('file', 'key')} gives.
   *
   * @param file the name of a file, which may leave its ending out
   */
  public Optional<String> property(String file, String key) {
    return Stream.of(file, file + ".properties")
        .flatMap(name -> Optional.ofNullable(propertyFiles.get(name)).stream())
        .flatMap(each -> Optional.ofNullable(each.get(key)).stream())
        .findFirst();
  }
}
