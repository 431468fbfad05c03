package dev.eventchain.eclipse.ui.text;

import org.eclipse.core.filebuffers.IDocumentSetupParticipant;
import org.eclipse.jface.text.IDocument;

/** Partitions documents with constraints in any editor. */
public final class OclDocuments implements IDocumentSetupParticipant {

  @Override
  public void setup(IDocument document) {
    Partitioner.install(document, Language.OCL);
  }
}
