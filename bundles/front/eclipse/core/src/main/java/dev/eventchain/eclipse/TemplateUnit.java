package dev.eventchain.eclipse;

import dev.eventchain.check.Metamodels;
import dev.eventchain.check.Validation;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.m2t.TemplateModule;
import dev.eventchain.templates.ShippedTemplates;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IResource;
import org.eclipse.emf.ecore.EPackage;

/** A template and the modules that it imports; checks that they compile. */
record TemplateUnit(IFile file, Path path, List<Path> metamodels) implements CheckUnit {

  private static final Set<String> RELEVANT = Set.of("mtl", "ecore");

  @Override
  public IResource subject() {
    return file;
  }

  /** Templates import others and use metamodels. */
  @Override
  public boolean dependsOn(IFile changed) {
    return RELEVANT.contains(CheckedFiles.kind(changed));
  }

  @Override
  public Validation check() {
    List<EPackage> packages = Metamodels.of(metamodels);
    // Templates of a project may import shipped ones; others may import from their own folder only.
    TemplateModule module =
        EventchainFolders.around(file).isPresent()
            ? TemplateModule.compile(
                path, ShippedTemplates.modules(ShippedTemplates.DEFAULT), packages)
            : TemplateModule.compile(path, packages);
    return new Validation(new Coverage(List.of(path.toString()), 0, List.of()), module.warnings());
  }
}
