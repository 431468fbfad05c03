package dev.eventchain.pipeline;

import dev.eventchain.check.ModelValidation;
import dev.eventchain.check.ReferenceFolders;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileRules;
import dev.eventchain.m2t.TemplateModule;
import dev.eventchain.pipeline.AnyModel.Template;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EPackage;

/**
 * The UML profiles in the folders of templates, {@code *.profile.uml}: templates may name their
 * stereotypes as types, whether or not there is a model that applies them.
 */
final class ProfilesBeside {

  /** Content of a file: packages, or what is wrong with it. */
  private record Read(List<EPackage> definitions, List<Diagnostic> problems) {}

  private final ReferenceFolders references;
  private final Map<Path, Read> known = new HashMap<>();

  ProfilesBeside(ReferenceFolders references) {
    this.references = references;
  }

  /**
   * Compiles a template.
   *
   * @param packages the metamodels that are known without the profiles, which do not replace any
   * @param compiler compiles it for metamodels
   * @throws DiagnosticException with its findings, and those about profiles that cannot be read
   */
  TemplateModule compile(
      Template template,
      List<EPackage> packages,
      Function<List<EPackage>, TemplateModule> compiler) {
    List<EPackage> all = new ArrayList<>(packages);
    List<Diagnostic> problems = new ArrayList<>();
    for (Path file : filesBeside(template)) {
      Read read = known.computeIfAbsent(file, this::read);
      problems.addAll(read.problems());
      read.definitions().stream()
          .filter(each -> all.stream().noneMatch(it -> each.getNsURI().equals(it.getNsURI())))
          .forEach(all::add);
    }
    try {
      return compiler.apply(all);
    } catch (DiagnosticException e) {
      List<Diagnostic> found = new ArrayList<>(e.diagnostics());
      found.addAll(problems);
      throw new DiagnosticException(e.reason(), found);
    }
  }

  private Read read(Path file) {
    try {
      return new Read(ModelValidation.profiles(file, references), List.of());
    } catch (DiagnosticException e) {
      return new Read(List.of(), e.diagnostics());
    }
  }

  private static List<Path> filesBeside(Template template) {
    Set<Path> folders = new LinkedHashSet<>();
    folders.add(template.main().resolveSibling(""));
    folders.addAll(template.sources());
    List<Path> files = new ArrayList<>();
    for (Path folder : folders) {
      if (Files.isDirectory(folder)) {
        try (Stream<Path> all = Files.list(folder)) {
          all.filter(file -> file.toString().endsWith(ModelValidation.PROFILE))
              .sorted()
              .forEach(files::add);
        } catch (IOException e) {
          throw FileRules.refusal("The folder", folder, e);
        }
      }
    }
    return files;
  }
}
