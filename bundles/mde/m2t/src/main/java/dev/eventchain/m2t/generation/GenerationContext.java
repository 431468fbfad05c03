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
 * Input of a generation besides the model.
 *
 * @param locator returns the location of a model element, for findings
 * @param earlier returns the content of an output file, usually {@link OutputFolder#read}; needed
 *     to keep protected areas
 * @param properties the properties for {@code getProperty('key')}
 * @param propertyFiles the properties for {@code getProperty('name', 'key')} by file name, in order
 * @param traits the options of the generation
 */
public record GenerationContext(
    Function<EObject, SourceLocation> locator,
    Function<String, Optional<byte[]>> earlier,
    Map<String, String> properties,
    Map<String, Map<String, String>> propertyFiles,
    Set<Trait> traits) {

  /** Options of a generation. */
  public enum Trait {
    /** The result has a trace of generated lines to template lines and elements. */
    TRACED,

    /** Problems that Acceleo ignores are warnings, not errors. */
    LENIENT,

    /** There is no output folder: file blocks other than printing ones are errors. */
    PRINTED_ONLY
  }

  /** Copies the traits. */
  public GenerationContext {
    traits = Set.copyOf(traits);
  }

  /** Returns a context with an empty output folder and no properties. */
  public static GenerationContext of(Function<EObject, SourceLocation> locator) {
    return new GenerationContext(locator, name -> Optional.empty(), Map.of(), Map.of(), Set.of());
  }

  /** Returns this context with the files of an output folder. */
  public GenerationContext withEarlier(Function<String, Optional<byte[]>> newEarlier) {
    return new GenerationContext(locator, newEarlier, properties, propertyFiles, traits);
  }

  /** Returns this context with other properties, which belong to no file. */
  public GenerationContext withProperties(Map<String, String> newProperties) {
    return new GenerationContext(
        locator, earlier, Map.copyOf(newProperties), propertyFiles, traits);
  }

  /**
   * Returns this context with other property files.
   *
   * @param newFiles the properties by file name, in the order of lookup
   */
  public GenerationContext withPropertyFiles(Map<String, Map<String, String>> newFiles) {
    Map<String, Map<String, String>> files =
        Collections.unmodifiableMap(new LinkedHashMap<>(newFiles));
    return new GenerationContext(locator, earlier, properties, files, traits);
  }

  /** Returns this context with more traits. */
  public GenerationContext with(Set<Trait> others) {
    Set<Trait> more = new HashSet<>(traits);
    more.addAll(others);
    return new GenerationContext(locator, earlier, properties, propertyFiles, more);
  }

  /** Returns this context with tracing of lines to template lines and elements. */
  public GenerationContext withTrace() {
    return with(Set.of(Trait.TRACED));
  }

  public boolean has(Trait trait) {
    return traits.contains(trait);
  }

  /**
   * Returns the value of {@code getProperty('key')}: a property without a file, otherwise that of
   * the first file with the key.
   */
  public Optional<String> property(String key) {
    return Stream.concat(Stream.of(properties), propertyFiles.values().stream())
        .flatMap(each -> Optional.ofNullable(each.get(key)).stream())
        .findFirst();
  }

  /**
   * Returns the value of {@code getProperty('file', 'key')}.
   *
   * @param file the name of a file, with or without extension
   */
  public Optional<String> property(String file, String key) {
    return Stream.of(file, file + ".properties")
        .flatMap(name -> Optional.ofNullable(propertyFiles.get(name)).stream())
        .flatMap(each -> Optional.ofNullable(each.get(key)).stream())
        .findFirst();
  }
}
