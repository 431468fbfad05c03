package dev.eventchain.eclipse.ui.text;

import org.eclipse.core.filebuffers.IDocumentSetupParticipant;
import org.eclipse.jface.text.IDocument;

/** Divides documents with constraints into partitions, whatever opens them. */
public final class OclDocuments implements IDocumentSetupParticipant {

  @Override
  public void setup(IDocument document) {
    Partitioner.install(document, Language.OCL);
  }
}
