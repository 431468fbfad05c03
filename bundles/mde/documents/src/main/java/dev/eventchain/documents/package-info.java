/** JSON and YAML files, read strictly and in one way, with the place of each value. */
package dev.eventchain.documents;
