package dev.eventchain.eclipse.ui.wizards;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.eclipse.ChainImport;
import dev.eventchain.eclipse.EventchainFolders;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectLayout;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.eclipse.core.resources.IContainer;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.resources.IWorkspaceRoot;
import org.eclipse.core.resources.ResourcesPlugin;
import org.eclipse.core.runtime.IPath;
import org.eclipse.jface.layout.GridDataFactory;
import org.eclipse.jface.layout.GridLayoutFactory;
import org.eclipse.jface.wizard.WizardPage;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Button;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.FileDialog;
import org.eclipse.swt.widgets.Label;
import org.eclipse.swt.widgets.Text;
import org.eclipse.ui.dialogs.SaveAsDialog;

/** Asks for a description and the location of its model, and shows the errors. */
final class ImportPage extends WizardPage {

  private static final int FINDINGS_HEIGHT = 120;

  private final IPath proposed;
  private Text source;
  private Text target;
  private Text name;
  private Text frequency;
  private Button replace;
  private Text findings;
  private ChainImport read;

  /**
   * @param folder the proposed folder of the model; null if nothing is selected
   */
  ImportPage(IContainer folder) {
    super("import");
    proposed = folder == null ? null : folder.getFullPath().append(ProjectFolder.MODEL);
    setTitle("Event Chain from JSON");
    setDescription(
        "Creates a model from the description of a chain, in the form in which language models"
            + " write it.");
  }

  @Override
  public void createControl(Composite parent) {
    Composite rows = new Composite(parent, SWT.NONE);
    GridLayoutFactory.swtDefaults().numColumns(3).applyTo(rows);
    createFields(rows);
    createFindings(rows);
    for (Text each : List.of(source, target, name, frequency)) {
      each.addModifyListener(event -> check());
    }
    replace.addListener(SWT.Selection, event -> check());
    setControl(rows);
    setPageComplete(false);
  }

  private void createFields(Composite rows) {
    source = text(rows, "&Description (JSON):");
    button(rows, "&Browse...").addListener(SWT.Selection, event -> browseSource());
    target = text(rows, "&Model (.xmi):");
    button(rows, "B&rowse...").addListener(SWT.Selection, event -> browseTarget());
    target.setText(proposed == null ? "" : proposed.toString());
    name = text(rows, "&Name of the chain:");
    new Label(rows, SWT.NONE);
    frequency = text(rows, "&Frequency in Hz (may be empty):");
    new Label(rows, SWT.NONE);
    replace = new Button(rows, SWT.CHECK);
    replace.setText("Re&place the model if it exists");
    GridDataFactory.fillDefaults().span(3, 1).applyTo(replace);
  }

  private void createFindings(Composite rows) {
    Label label = new Label(rows, SWT.NONE);
    label.setText("Findings:");
    GridDataFactory.fillDefaults().span(3, 1).applyTo(label);
    findings = new Text(rows, SWT.BORDER | SWT.MULTI | SWT.READ_ONLY | SWT.WRAP | SWT.V_SCROLL);
    GridDataFactory.fillDefaults()
        .span(3, 1)
        .grab(true, true)
        .hint(SWT.DEFAULT, FINDINGS_HEIGHT)
        .applyTo(findings);
  }

  private static Text text(Composite rows, String label) {
    new Label(rows, SWT.NONE).setText(label);
    Text text = new Text(rows, SWT.BORDER | SWT.SINGLE);
    GridDataFactory.fillDefaults().grab(true, false).applyTo(text);
    return text;
  }

  private static Button button(Composite rows, String label) {
    Button button = new Button(rows, SWT.PUSH);
    button.setText(label);
    return button;
  }

  private void browseSource() {
    FileDialog dialog = new FileDialog(getShell(), SWT.OPEN);
    dialog.setFilterExtensions(new String[] {"*.json", "*"});
    String chosen = dialog.open();
    if (chosen != null) {
      source.setText(chosen);
      if (name.getText().isEmpty()) {
        String file = Path.of(chosen).getFileName().toString();
        name.setText(ChainNames.of(file.replaceAll("\\.json$", "")));
      }
    }
  }

  private void browseTarget() {
    SaveAsDialog dialog = new SaveAsDialog(getShell());
    dialog.setOriginalName(ProjectFolder.MODEL);
    dialog.open();
    if (dialog.getResult() != null) {
      target.setText(dialog.getResult().toString());
    }
  }

  /** Returns the model as last read; empty if there are errors. */
  Optional<ChainImport> read() {
    return Optional.ofNullable(read);
  }

  /** Returns the workspace file for the model. */
  IFile target() {
    IWorkspaceRoot root = ResourcesPlugin.getWorkspace().getRoot();
    return root.getFile(IPath.fromPortableString(target.getText().strip()));
  }

  private void check() {
    read = null;
    findings.setText("");
    String problem = problem();
    if (problem.isEmpty()) {
      problem = readDescription();
    }
    setErrorMessage(problem.isEmpty() ? null : problem);
    boolean replaces = problem.isEmpty() && target().exists();
    setMessage(
        replaces ? target().getFullPath() + " will be replaced." : null, replaces ? WARNING : NONE);
    setPageComplete(problem.isEmpty());
  }

  private String problem() {
    IPath path = IPath.fromPortableString(target.getText().strip());
    IWorkspaceRoot root = ResourcesPlugin.getWorkspace().getRoot();
    IResource parent = path.segmentCount() < 2 ? null : root.findMember(path.removeLastSegments(1));
    if (!Files.isRegularFile(path(source.getText()))) {
      return "Choose the file with the description.";
    } else if (!(parent instanceof IContainer) || !parent.isAccessible()) {
      return "Choose a file of the workspace, in a folder that exists: /project/model/chain.xmi.";
    } else if (!"xmi".equals(path.getFileExtension())) {
      return "The name of the model ends with .xmi.";
    } else if (!ChainNames.isValid(name.getText())) {
      return "The name of a chain is a lower-case letter, then lower-case letters, digits and '_'.";
    } else if (!frequency.getText().isBlank() && frequency().isEmpty()) {
      return "The frequency is a number above 0.";
    } else if (target().exists() && !replace.getSelection()) {
      return path + " exists. Tick the box below to replace it, or name another file.";
    }
    return "";
  }

  private static Path path(String text) {
    try {
      return Path.of(text.strip());
    } catch (InvalidPathException e) {
      return Path.of(""); // a folder: no file
    }
  }

  private OptionalDouble frequency() {
    try {
      double value = Double.parseDouble(frequency.getText().strip());
      return value > 0 && Double.isFinite(value)
          ? OptionalDouble.of(value)
          : OptionalDouble.empty();
    } catch (NumberFormatException e) {
      return OptionalDouble.empty();
    }
  }

  /** Reads the description, shows the findings, and returns the remaining problem, if any. */
  private String readDescription() {
    IContainer around = EventchainFolders.around(target()).orElse(target().getProject());
    IPath place = around.getLocation();
    Path requirements =
        place == null ? path("") : place.toPath().resolve(ProjectLayout.REQUIREMENTS);
    try {
      read = ChainImport.read(path(source.getText()), name.getText(), requirements, frequency());
      show(read.diagnostics());
      return "";
    } catch (DiagnosticException e) {
      show(e.diagnostics());
      return "The description has errors, which are listed below. Nothing is written.";
    }
  }

  private void show(List<Diagnostic> found) {
    findings.setText(found.stream().map(ImportPage::line).collect(Collectors.joining("\n")));
  }

  private static String line(Diagnostic finding) {
    int line = finding.location().line();
    String severity = finding.severity().name().toLowerCase(java.util.Locale.ROOT);
    return (line > 0 ? "Line " + line + ", " : "")
        + severity
        + ": "
        + finding.message()
        + (finding.hint().isEmpty() ? "" : " " + finding.hint());
  }
}
