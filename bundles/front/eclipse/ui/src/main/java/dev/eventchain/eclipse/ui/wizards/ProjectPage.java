package dev.eventchain.eclipse.ui.wizards;

import dev.eventchain.eclipse.Program;
import java.nio.file.Files;
import java.nio.file.Path;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.jface.layout.GridDataFactory;
import org.eclipse.jface.layout.GridLayoutFactory;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Combo;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Label;
import org.eclipse.swt.widgets.Text;
import org.eclipse.ui.dialogs.WizardNewProjectCreationPage;

/** Asks for the name, location and initial content of a project. */
final class ProjectPage extends WizardNewProjectCreationPage {

  private static final String STARTER = "A small project that runs as it is";

  private Combo start;
  private Text chain;
  private boolean chainTyped;
  private boolean filling;

  ProjectPage() {
    super("project");
    setTitle("Eventchain Project");
    setDescription("Creates a project with an event chain, its scenarios and its requirements.");
  }

  @Override
  public void createControl(Composite parent) {
    super.createControl(parent);
    Composite rows = new Composite((Composite) getControl(), SWT.NONE);
    GridLayoutFactory.fillDefaults().numColumns(2).margins(5, 5).applyTo(rows);
    GridDataFactory.fillDefaults().grab(true, false).applyTo(rows);
    new Label(rows, SWT.NONE).setText("&Start with:");
    start = new Combo(rows, SWT.READ_ONLY | SWT.DROP_DOWN);
    start.add(STARTER);
    ProjectContent.EXAMPLES.forEach(name -> start.add("Example: " + name));
    start.select(0);
    new Label(rows, SWT.NONE).setText("Name of the &chain:");
    chain = new Text(rows, SWT.BORDER | SWT.SINGLE);
    GridDataFactory.fillDefaults().grab(true, false).applyTo(start);
    GridDataFactory.fillDefaults().grab(true, false).applyTo(chain);
    start.addModifyListener(event -> setPageComplete(validatePage()));
    chain.addModifyListener(
        event -> {
          if (!filling) {
            chainTyped = !chain.getText().isEmpty();
            setPageComplete(validatePage());
          }
        });
    setPageComplete(validatePage());
    setErrorMessage(null);
    setMessage(null);
  }

  /** Returns the folder name of the example; empty for the starter. */
  String example() {
    int index = start.getSelectionIndex();
    return index <= 0 ? "" : ProjectContent.EXAMPLES.get(index - 1);
  }

  /** Returns the chain's name for the starter. */
  String chain() {
    return chain.getText();
  }

  /** Returns the folder for the project's files. */
  Path folder() {
    return useDefaults()
        ? getLocationPath().append(getProjectName()).toPath()
        : getLocationPath().toPath();
  }

  @Override
  protected boolean validatePage() {
    if (chain == null) {
      return super.validatePage(); // the rest of the page does not exist yet
    }
    fillChain();
    if (!super.validatePage()) {
      return false;
    }
    String problem = problem();
    setErrorMessage(problem.isEmpty() ? null : problem);
    return problem.isEmpty();
  }

  private void fillChain() {
    chain.setEnabled(example().isEmpty());
    if (!chainTyped) {
      filling = true;
      String name = getProjectName().isEmpty() ? "" : ChainNames.of(getProjectName());
      chain.setText(name);
      filling = false;
    }
  }

  private String problem() {
    if (example().isEmpty() && !ChainNames.isValid(chain())) {
      return "The name of a chain is a lower-case letter, then lower-case letters, digits and '_'.";
    }
    Path folder = folder();
    if (Files.exists(folder) && !Files.isDirectory(folder)) {
      return folder + " is a file.";
    } else if (!Files.isWritable(ProjectContent.existing(folder))) {
      return "Nothing can be written in " + ProjectContent.existing(folder) + ".";
    } else if (!ProjectContent.isFree(folder)) {
      return "The folder " + folder + " is not empty. Choose another name or place.";
    }
    try {
      Program program = Program.find();
      if (!example().isEmpty()) {
        ProjectContent.example(program, example());
      }
      return "";
    } catch (CoreException e) {
      return e.getStatus().getMessage();
    }
  }
}
