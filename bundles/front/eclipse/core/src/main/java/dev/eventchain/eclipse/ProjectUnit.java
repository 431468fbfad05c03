package dev.eventchain.eclipse;

import dev.eventchain.check.ProjectValidation;
import dev.eventchain.check.Validation;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectLayout;
import dev.eventchain.project.SuppressionFile;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.eclipse.core.resources.IContainer;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.runtime.IPath;

/**
 * A folder with an {@code eventchain.yaml}: the unit that {@code eventchain validate} checks.
 *
 * @param validation the validation, kept between builds because it rereads only changed files
 */
record ProjectUnit(IContainer folder, Path path, ProjectValidation validation)
    implements CheckUnit {

  /** Results that are checked; all others are derived from them. */
  private static final Set<String> CHECKED_RESULTS =
      Set.of(ProjectFolder.MODEL, ProjectFolder.DESCRIPTION, ProjectFolder.GENERATED);

  @Override
  public IResource subject() {
    return folder.getFile(IPath.fromOSString(ProjectLayout.CONFIGURATION));
  }

  @Override
  public boolean dependsOn(IFile file) {
    if (!folder.getFullPath().isPrefixOf(file.getFullPath())) {
      return CheckedFiles.kind(file).equals("ocl"); // documents may import others from elsewhere
    }
    IPath name = file.getFullPath().makeRelativeTo(folder.getFullPath());
    return name.segment(0).equals(ProjectLayout.OUTPUT)
        ? name.segmentCount() == 2 && CHECKED_RESULTS.contains(name.lastSegment())
        : !name.segment(0).startsWith(".");
  }

  /** Returns whether a model is the editable model of this folder. */
  boolean hasChain(IFile model) {
    return new ProjectFolder(path).editedModel().equals(CheckedFiles.pathOf(model));
  }

  /** Returns whether a document contains the rules of this folder. */
  boolean hasRules(IFile document) {
    return document.equals(folder.getFile(IPath.fromOSString(ProjectLayout.CONSTRAINTS)));
  }

  @Override
  public Validation check() {
    ProjectFolder project = new ProjectFolder(path);
    Suppressions suppressions =
        project
            .suppressions()
            .map(
                file ->
                    SuppressionFile.read(
                        file, LocalDate.now(ZoneId.systemDefault()), RulePages::page))
            .orElse(Suppressions.NONE);
    Validation all = validation.validate();
    if (all.coverage().equals(Coverage.NONE)) {
      return all; // the reason why nothing was checked cannot be suppressed
    }
    List<Diagnostic> found = new ArrayList<>(suppressions.part(all.diagnostics()).remaining());
    found.addAll(suppressions.warnings(all.diagnostics(), all.coverage(), false));
    return new Validation(all.coverage(), found);
  }
}
