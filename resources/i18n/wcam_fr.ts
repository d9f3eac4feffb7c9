<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR">
<context>
    <name>NodeText</name>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>x, y, z</source>
        <translation>x, y, z</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>angles about the moving axes x, y, z, in this order</source>
        <translation>angles autour des axes mobiles x, y, z, dans cet ordre</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>CAD or mesh file of the part</source>
        <translation>fichier CAO ou maillage de la pièce</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Faces</translation>
    </message>
    <message>
        <source>numbers of the faces of the working surface; none: chosen automatically</source>
        <translation>numéros des faces de la surface de travail ; aucun : choix automatique</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Plaque</translation>
    </message>
    <message>
        <source>Imported part</source>
        <translation>Pièce importée</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Dimensions</translation>
    </message>
    <message>
        <source>length, width and thickness of a plate</source>
        <translation>longueur, largeur et épaisseur d’une plaque</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>part that is built on</source>
        <translation>pièce sur laquelle on construit</translation>
    </message>
    <message>
        <source>Edge of a part</source>
        <translation>Arête d’une pièce</translation>
    </message>
    <message>
        <source>Polyline file</source>
        <translation>Fichier de polyligne</translation>
    </message>
    <message>
        <source>Formulas of t</source>
        <translation>Formules de t</translation>
    </message>
    <message>
        <source>part whose edge is the guide</source>
        <translation>pièce dont une arête est le guide</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Arête</translation>
    </message>
    <message>
        <source>number or name of the edge</source>
        <translation>numéro ou nom de l’arête</translation>
    </message>
    <message>
        <source>Reversed</source>
        <translation>Inversée</translation>
    </message>
    <message>
        <source>text file of points</source>
        <translation>fichier texte de points</translation>
    </message>
    <message>
        <source>First t</source>
        <translation>Premier t</translation>
    </message>
    <message>
        <source>Last t</source>
        <translation>Dernier t</translation>
    </message>
    <message>
        <source>process file; parameters below win over it</source>
        <translation>fichier de procédé ; les paramètres ci-dessous l’emportent</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Stratégie</translation>
    </message>
    <message>
        <source>Enabled</source>
        <translation>Active</translation>
    </message>
    <message>
        <source>an operation that is not enabled is left out</source>
        <translation>une opération inactive est laissée de côté</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Pièces</translation>
    </message>
    <message>
        <source>Substrate</source>
        <translation>Substrat</translation>
    </message>
    <message>
        <source>Guide curve</source>
        <translation>Courbe guide</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Procédé</translation>
    </message>
    <message>
        <source>Path file</source>
        <translation>Fichier de trajectoire</translation>
    </message>
    <message>
        <source>table of a path that was planned elsewhere</source>
        <translation>table d’une trajectoire planifiée ailleurs</translation>
    </message>
    <message>
        <source>Post-processor</source>
        <translation>Post-processeur</translation>
    </message>
    <message>
        <source>Operations</source>
        <translation>Opérations</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>folder below the output folder</source>
        <translation>dossier sous le dossier de sortie</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Trajectoire</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>Cell</source>
        <translation>Cellule</translation>
    </message>
    <message>
        <source>robot, positioner and torch; Project &gt; Choose cell takes another file</source>
        <translation>robot, positionneur et torche ; Projet &gt; Choisir la cellule prend un autre fichier</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>The whole surface</source>
        <translation>Toute la surface</translation>
    </message>
    <message>
        <source>Outer side</source>
        <translation>Côté extérieur</translation>
    </message>
    <message>
        <source>Inner side</source>
        <translation>Côté intérieur</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Milieu</translation>
    </message>
    <message>
        <source>Side of a wall</source>
        <translation>Côté d’une paroi</translation>
    </message>
    <message>
        <source>working surface of a solid wall</source>
        <translation>surface de travail d’une paroi épaisse</translation>
    </message>
    <message>
        <source>an edit that is not enabled is left out</source>
        <translation>une retouche désactivée est ignorée</translation>
    </message>
    <message>
        <source>the parts to build</source>
        <translation>les pièces à construire</translation>
    </message>
    <message>
        <source>the operations to write; none is checked: all</source>
        <translation>les opérations à écrire ; aucune n’est cochée : toutes</translation>
    </message>
    <message>
        <source>Counted from 1 in each layer; -1 is all beads.</source>
        <translation>Compté à partir de 1 dans chaque couche ; -1 désigne tous les cordons.</translation>
    </message>
    <message>
        <source>Counted from 1, as in the view; -1 is the top layer, -2 the one below it. Belongs to the range.</source>
        <translation>Compté à partir de 1, comme dans la vue ; -1 est la couche du haut, -2 celle au-dessous. Fait partie de la plage.</translation>
    </message>
</context>
<context>
    <name>engine</name>
    <message>
        <source>$ACT_EX_AX</source>
        <translation>$ACT_EX_AX</translation>
    </message>
    <message>
        <source>Advance run</source>
        <translation>Avance de lecture</translation>
    </message>
    <message>
        <source>Alternate direction</source>
        <translation>Alterner le sens</translation>
    </message>
    <message>
        <source>Angular tolerance</source>
        <translation>Tolérance angulaire</translation>
    </message>
    <message>
        <source>Approach height</source>
        <translation>Hauteur d’approche</translation>
    </message>
    <message>
        <source>Approximation distance</source>
        <translation>Distance d’approximation</translation>
    </message>
    <message>
        <source>Approximation velocity</source>
        <translation>Vitesse d’approximation</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>Arc</translation>
    </message>
    <message>
        <source>Arc end schedule</source>
        <translation>Programme de fin d’arc</translation>
    </message>
    <message>
        <source>Arc on and off</source>
        <translation>Allumage et extinction de l’arc</translation>
    </message>
    <message>
        <source>Arc output</source>
        <translation>Sortie de l’arc</translation>
    </message>
    <message>
        <source>Arc start schedule</source>
        <translation>Programme de début d’arc</translation>
    </message>
    <message>
        <source>Axes of the turn numbers</source>
        <translation>Axes des nombres de tours</translation>
    </message>
    <message>
        <source>Base number</source>
        <translation>Numéro de base</translation>
    </message>
    <message>
        <source>Bead</source>
        <translation>Cordon</translation>
    </message>
    <message>
        <source>Bead width</source>
        <translation>Largeur de cordon</translation>
    </message>
    <message>
        <source>Build direction</source>
        <translation>Direction de construction</translation>
    </message>
    <message>
        <source>CNT value</source>
        <translation>Valeur de CNT</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>Contrôles</translation>
    </message>
    <message>
        <source>Chord error</source>
        <translation>Erreur de corde</translation>
    </message>
    <message>
        <source>Chord tolerance</source>
        <translation>Tolérance de corde</translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Commentaires</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Contrôleur</translation>
    </message>
    <message>
        <source>Coordinated motion</source>
        <translation>Mouvement coordonné</translation>
    </message>
    <message>
        <source>Coupled positioner</source>
        <translation>Positionneur couplé</translation>
    </message>
    <message>
        <source>Crater fill</source>
        <translation>Remplissage de cratère</translation>
    </message>
    <message>
        <source>Crater fill time</source>
        <translation>Temps de remplissage de cratère</translation>
    </message>
    <message>
        <source>Decimals of Cartesian positions</source>
        <translation>Décimales des positions cartésiennes</translation>
    </message>
    <message>
        <source>Decimals of angles</source>
        <translation>Décimales des angles</translation>
    </message>
    <message>
        <source>Decimals of joint values</source>
        <translation>Décimales des valeurs d’axes</translation>
    </message>
    <message>
        <source>Decimals of lengths</source>
        <translation>Décimales des longueurs</translation>
    </message>
    <message>
        <source>Decimals of speeds</source>
        <translation>Décimales des vitesses</translation>
    </message>
    <message>
        <source>Density of the wire</source>
        <translation>Masse volumique du fil</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>Elbow singularity margin</source>
        <translation>Marge à la singularité du coude</translation>
    </message>
    <message>
        <source>End height</source>
        <translation>Hauteur finale</translation>
    </message>
    <message>
        <source>Fields of DEFAULT_GROUP</source>
        <translation>Champs de DEFAULT_GROUP</translation>
    </message>
    <message>
        <source>First layer, in steps</source>
        <translation>Première couche, en pas</translation>
    </message>
    <message>
        <source>Frame of Cartesian positions</source>
        <translation>Repère des positions cartésiennes</translation>
    </message>
    <message>
        <source>Greatest layer height</source>
        <translation>Hauteur de couche maximale</translation>
    </message>
    <message>
        <source>Greatest point spacing</source>
        <translation>Écart maximal des points</translation>
    </message>
    <message>
        <source>Greatest travel speed</source>
        <translation>Vitesse d’avance maximale</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>Job number of the welding source</source>
        <translation>Numéro de job de la source</translation>
    </message>
    <message>
        <source>Joint speed of travel moves</source>
        <translation>Vitesse d’axes des trajets</translation>
    </message>
    <message>
        <source>KRL at arc off</source>
        <translation>KRL à l’extinction</translation>
    </message>
    <message>
        <source>KRL at arc on</source>
        <translation>KRL à l’allumage</translation>
    </message>
    <message>
        <source>Largest joint step</source>
        <translation>Plus grand pas d’axe</translation>
    </message>
    <message>
        <source>Lateral tilt</source>
        <translation>Inclinaison latérale</translation>
    </message>
    <message>
        <source>Layer step</source>
        <translation>Pas des couches</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Couches</translation>
    </message>
    <message>
        <source>Lead angle</source>
        <translation>Angle d’avance</translation>
    </message>
    <message>
        <source>Least dexterity</source>
        <translation>Dextérité minimale</translation>
    </message>
    <message>
        <source>Length of names</source>
        <translation>Longueur des noms</translation>
    </message>
    <message>
        <source>Machine number of the positioner</source>
        <translation>Numéro de machine du positionneur</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Sortie</translation>
    </message>
    <message>
        <source>Own build direction</source>
        <translation>Direction de construction propre</translation>
    </message>
    <message>
        <source>Payload schedule</source>
        <translation>Charge utile</translation>
    </message>
    <message>
        <source>Points passed</source>
        <translation>Points traversés</translation>
    </message>
    <message>
        <source>Points per program</source>
        <translation>Points par programme</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Positions</translation>
    </message>
    <message>
        <source>Program name</source>
        <translation>Nom du programme</translation>
    </message>
    <message>
        <source>Random seed</source>
        <translation>Graine aléatoire</translation>
    </message>
    <message>
        <source>Range of A and C</source>
        <translation>Domaine de A et C</translation>
    </message>
    <message>
        <source>Register for the wire speed</source>
        <translation>Registre de la vitesse de fil</translation>
    </message>
    <message>
        <source>Remote tool centre point</source>
        <translation>TCP externe</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Réparer</translation>
    </message>
    <message>
        <source>Robot configuration</source>
        <translation>Configuration du robot</translation>
    </message>
    <message>
        <source>Rotation about the torch</source>
        <translation>Rotation autour de la torche</translation>
    </message>
    <message>
        <source>Safe height</source>
        <translation>Hauteur de sécurité</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Échantillonnage</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>Début de cordon</translation>
    </message>
    <message>
        <source>Seam direction</source>
        <translation>Direction du début</translation>
    </message>
    <message>
        <source>Seam shift</source>
        <translation>Décalage du début</translation>
    </message>
    <message>
        <source>Shoulder singularity margin</source>
        <translation>Marge à la singularité de l’épaule</translation>
    </message>
    <message>
        <source>Smallest layer height</source>
        <translation>Hauteur de couche minimale</translation>
    </message>
    <message>
        <source>Smallest travel speed</source>
        <translation>Vitesse d’avance minimale</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Status bits of PTP positions</source>
        <translation>Bits d’état des positions PTP</translation>
    </message>
    <message>
        <source>Tolerance of the vertical</source>
        <translation>Tolérance de verticalité</translation>
    </message>
    <message>
        <source>Tool axis</source>
        <translation>Axe outil</translation>
    </message>
    <message>
        <source>Tool frame of the positioner</source>
        <translation>Repère outil du positionneur</translation>
    </message>
    <message>
        <source>Tool number</source>
        <translation>Numéro d’outil</translation>
    </message>
    <message>
        <source>Torch</source>
        <translation>Torche</translation>
    </message>
    <message>
        <source>Travel</source>
        <translation>Trajets</translation>
    </message>
    <message>
        <source>Travel speed</source>
        <translation>Vitesse d’avance</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Unit of speeds</source>
        <translation>Unité des vitesses</translation>
    </message>
    <message>
        <source>User frame of the positioner</source>
        <translation>Repère utilisateur du positionneur</translation>
    </message>
    <message>
        <source>User frame of the robot (UF)</source>
        <translation>Repère utilisateur du robot (UF)</translation>
    </message>
    <message>
        <source>Variable for the wire speed</source>
        <translation>Variable de la vitesse de fil</translation>
    </message>
    <message>
        <source>Weld tolerance</source>
        <translation>Tolérance de soudage</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenêtre</translation>
    </message>
    <message>
        <source>Wire</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>Wire diameter</source>
        <translation>Diamètre du fil</translation>
    </message>
    <message>
        <source>Wire feed speed</source>
        <translation>Vitesse de fil</translation>
    </message>
    <message>
        <source>Wrist singularity margin</source>
        <translation>Marge à la singularité du poignet</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Précision</translation>
    </message>
    <message>
        <source>Adaptive heights</source>
        <translation>Hauteurs adaptatives</translation>
    </message>
    <message>
        <source>Aligned in one direction</source>
        <translation>Alignés dans une direction</translation>
    </message>
    <message>
        <source>All at the last layer</source>
        <translation>Tous à la dernière couche</translation>
    </message>
    <message>
        <source>Alternate by</source>
        <translation>Alterner par</translation>
    </message>
    <message>
        <source>Always over the safe height</source>
        <translation>Toujours par la hauteur de sécurité</translation>
    </message>
    <message>
        <source>Angle step</source>
        <translation>Pas angulaire</translation>
    </message>
    <message>
        <source>Arc length</source>
        <translation>Longueur d’arc</translation>
    </message>
    <message>
        <source>Arc on in lead-in and lead-out</source>
        <translation>Arc allumé en entrée et en sortie</translation>
    </message>
    <message>
        <source>As the strategy lists them</source>
        <translation>Comme la stratégie les donne</translation>
    </message>
    <message>
        <source>At the border of the surface</source>
        <translation>Au bord de la surface</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Automatic guide</source>
        <translation>Guide automatique</translation>
    </message>
    <message>
        <source>Automatic: local for curved layers, else layer</source>
        <translation>Automatique : locale pour les couches courbes, sinon par couche</translation>
    </message>
    <message>
        <source>Away from the starts of the last layers</source>
        <translation>Loin des débuts des dernières couches</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Axis direction</source>
        <translation>Direction de l’axe</translation>
    </message>
    <message>
        <source>Axis origin</source>
        <translation>Origine de l’axe</translation>
    </message>
    <message>
        <source>Bead widths of the file</source>
        <translation>Largeurs de cordon du fichier</translation>
    </message>
    <message>
        <source>Beads</source>
        <translation>Cordons</translation>
    </message>
    <message>
        <source>Beads side by side on faces or a whole surface, in layers along the normal.</source>
        <translation>Cordons côte à côte sur des faces ou une surface entière, en couches le long de la normale.</translation>
    </message>
    <message>
        <source>Body of revolution</source>
        <translation>Corps de révolution</translation>
    </message>
    <message>
        <source>Branches</source>
        <translation>Branches</translation>
    </message>
    <message>
        <source>By the axis rules of the path, from the file&apos;s normals</source>
        <translation>Par les règles d’axe, avec les normales du fichier</translation>
    </message>
    <message>
        <source>By velocity (C_VEL)</source>
        <translation>Par la vitesse (C_VEL)</translation>
    </message>
    <message>
        <source>Cartesian</source>
        <translation>Cartésiennes</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Centimètres</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Centre</translation>
    </message>
    <message>
        <source>Centre distance, in bead widths</source>
        <translation>Entraxe, en largeurs de cordon</translation>
    </message>
    <message>
        <source>Centre the mean</source>
        <translation>Centrer la moyenne</translation>
    </message>
    <message>
        <source>Change of deposit</source>
        <translation>Changement de dépôt</translation>
    </message>
    <message>
        <source>Changes at</source>
        <translation>Change à</translation>
    </message>
    <message>
        <source>Chord</source>
        <translation>Corde</translation>
    </message>
    <message>
        <source>Clearance of direct links</source>
        <translation>Garde des liaisons directes</translation>
    </message>
    <message>
        <source>Concentric from the border</source>
        <translation>Concentriques depuis le bord</translation>
    </message>
    <message>
        <source>Conduction along the build direction</source>
        <translation>Conduction selon la construction</translation>
    </message>
    <message>
        <source>Cone angle</source>
        <translation>Angle du cône</translation>
    </message>
    <message>
        <source>Cones around the axis</source>
        <translation>Cônes autour de l’axe</translation>
    </message>
    <message>
        <source>Continuous</source>
        <translation>Continu</translation>
    </message>
    <message>
        <source>Continuous: walls and zigzag in as few beads as possible</source>
        <translation>Continu : parois et zigzag en le moins de cordons possible</translation>
    </message>
    <message>
        <source>Contour is the bead&apos;s</source>
        <translation>Le contour est du cordon</translation>
    </message>
    <message>
        <source>Contour: concentric until full</source>
        <translation>Contours : concentriques jusqu’au plein</translation>
    </message>
    <message>
        <source>Cooling length</source>
        <translation>Longueur de refroidissement</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Couverture</translation>
    </message>
    <message>
        <source>Curved layers at a constant distance along the surface from the border on which the part stands.</source>
        <translation>Couches courbes à distance constante, le long de la surface, du bord sur lequel la pièce repose.</translation>
    </message>
    <message>
        <source>Curved layers that follow the lower and the upper border of a wall.</source>
        <translation>Couches courbes qui suivent les bords inférieur et supérieur d’une paroi.</translation>
    </message>
    <message>
        <source>Curved layers, each at the same distance from the one below at every point.</source>
        <translation>Couches courbes, chacune à la même distance de la précédente en tout point.</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <source>Cut off by a plane</source>
        <translation>Coupée par un plan</translation>
    </message>
    <message>
        <source>Cuts a part where its layers part or join and builds the pieces in a chosen order, each layer on those that lie below it.</source>
        <translation>Coupe une pièce où ses couches se séparent ou se joignent et construit les morceaux dans un ordre choisi, chaque couche sur celles d’en dessous.</translation>
    </message>
    <message>
        <source>Cylinders around the axis</source>
        <translation>Cylindres autour de l’axe</translation>
    </message>
    <message>
        <source>Decimals</source>
        <translation>Décimales</translation>
    </message>
    <message>
        <source>Decomposition</source>
        <translation>Décomposition</translation>
    </message>
    <message>
        <source>Deposit</source>
        <translation>Dépôt</translation>
    </message>
    <message>
        <source>Digital output</source>
        <translation>Sortie numérique</translation>
    </message>
    <message>
        <source>Direction across the beads</source>
        <translation>Direction en travers des cordons</translation>
    </message>
    <message>
        <source>Direction of the axis</source>
        <translation>Direction de l’axe</translation>
    </message>
    <message>
        <source>Distance by</source>
        <translation>Distance par</translation>
    </message>
    <message>
        <source>Distance of seams</source>
        <translation>Distance des débuts</translation>
    </message>
    <message>
        <source>Each at the layer that its distance asks for</source>
        <translation>Chacun à la couche que sa distance demande</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>End distance</source>
        <translation>Distance finale</translation>
    </message>
    <message>
        <source>Equal steps on every generatrix; the seam drifts</source>
        <translation>Pas égaux sur chaque génératrice ; le début dérive</translation>
    </message>
    <message>
        <source>Exact starts</source>
        <translation>Débuts exacts</translation>
    </message>
    <message>
        <source>Farthest from the heat of the beads before</source>
        <translation>Le plus loin de la chaleur des cordons précédents</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Champ</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Remplissage</translation>
    </message>
    <message>
        <source>Fill narrow places</source>
        <translation>Remplir les passages étroits</translation>
    </message>
    <message>
        <source>First layer, in heights</source>
        <translation>Première couche, en hauteurs</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Free length before the closure</source>
        <translation>Longueur libre avant la fermeture</translation>
    </message>
    <message>
        <source>From the file, else numeric</source>
        <translation>Du fichier, sinon numérique</translation>
    </message>
    <message>
        <source>Further contours</source>
        <translation>Contours supplémentaires</translation>
    </message>
    <message>
        <source>Global: the substrate&apos;s build direction</source>
        <translation>Globale : direction de construction du substrat</translation>
    </message>
    <message>
        <source>Golden ratio from layer to layer</source>
        <translation>Nombre d’or de couche en couche</translation>
    </message>
    <message>
        <source>Greatest bead width</source>
        <translation>Largeur de cordon maximale</translation>
    </message>
    <message>
        <source>Greatest deposit</source>
        <translation>Dépôt maximal</translation>
    </message>
    <message>
        <source>Greatest filling</source>
        <translation>Remplissage maximal</translation>
    </message>
    <message>
        <source>Greatest inclination</source>
        <translation>Inclinaison maximale</translation>
    </message>
    <message>
        <source>Greatest turn of the axis</source>
        <translation>Rotation maximale de l’axe</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Guide</translation>
    </message>
    <message>
        <source>Half-planes through the axis</source>
        <translation>Demi-plans par l’axe</translation>
    </message>
    <message>
        <source>Header line</source>
        <translation>Ligne d’en-tête</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Chaleur</translation>
    </message>
    <message>
        <source>Hybrid: contours outside, zigzag inside</source>
        <translation>Hybride : contours dehors, zigzag dedans</translation>
    </message>
    <message>
        <source>In a corner, best a concave one</source>
        <translation>Dans un coin, de préférence rentrant</translation>
    </message>
    <message>
        <source>In the schedule</source>
        <translation>Dans le programme d’arc</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Pouces</translation>
    </message>
    <message>
        <source>Inner side</source>
        <translation>Côté intérieur</translation>
    </message>
    <message>
        <source>Inner side: the bead lies outside, as machining stock</source>
        <translation>Côté intérieur : le cordon est dehors, en surépaisseur</translation>
    </message>
    <message>
        <source>Inside first</source>
        <translation>Intérieur d’abord</translation>
    </message>
    <message>
        <source>Iso-values of a field: any single-branch part</source>
        <translation>Iso-valeurs d’un champ : toute pièce sans branche</translation>
    </message>
    <message>
        <source>Joint values</source>
        <translation>Valeurs d’axes</translation>
    </message>
    <message>
        <source>Keep the order</source>
        <translation>Garder l’ordre</translation>
    </message>
    <message>
        <source>Lay them as a single bead</source>
        <translation>Les déposer en un cordon</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Couche</translation>
    </message>
    <message>
        <source>Layer by layer over all branches</source>
        <translation>Couche par couche sur toutes les branches</translation>
    </message>
    <message>
        <source>Layer height</source>
        <translation>Hauteur de couche</translation>
    </message>
    <message>
        <source>Layer heights of the file</source>
        <translation>Hauteurs de couche du fichier</translation>
    </message>
    <message>
        <source>Layer surface</source>
        <translation>Surface de couche</translation>
    </message>
    <message>
        <source>Layer: one direction for each layer</source>
        <translation>Couche : une direction par couche</translation>
    </message>
    <message>
        <source>Layers are</source>
        <translation>Les couches sont</translation>
    </message>
    <message>
        <source>Layers follow</source>
        <translation>Les couches suivent</translation>
    </message>
    <message>
        <source>Layers on cylinders, cones, spheres or half-planes around an axis: flanges on a shaft, blades on a hub, bent walls.</source>
        <translation>Couches sur cylindres, cônes, sphères ou demi-plans autour d’un axe : brides sur un arbre, pales sur un moyeu, parois courbées.</translation>
    </message>
    <message>
        <source>Layers to keep away from</source>
        <translation>Couches à éviter</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Lead-out</source>
        <translation>Sortie</translation>
    </message>
    <message>
        <source>Least area</source>
        <translation>Aire minimale</translation>
    </message>
    <message>
        <source>Least bead length</source>
        <translation>Longueur de cordon minimale</translation>
    </message>
    <message>
        <source>Least bead width</source>
        <translation>Largeur de cordon minimale</translation>
    </message>
    <message>
        <source>Least branch</source>
        <translation>Branche minimale</translation>
    </message>
    <message>
        <source>Least coverage</source>
        <translation>Couverture minimale</translation>
    </message>
    <message>
        <source>Least deposit</source>
        <translation>Dépôt minimal</translation>
    </message>
    <message>
        <source>Least radius</source>
        <translation>Rayon minimal</translation>
    </message>
    <message>
        <source>Level set of a field</source>
        <translation>Ligne de niveau d’un champ</translation>
    </message>
    <message>
        <source>Lift of the wipe</source>
        <translation>Levée de l’essuyage</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Limites</translation>
    </message>
    <message>
        <source>Line angle</source>
        <translation>Angle des lignes</translation>
    </message>
    <message>
        <source>Links between beads</source>
        <translation>Liaisons entre cordons</translation>
    </message>
    <message>
        <source>Local: tangent to the wall at every point</source>
        <translation>Locale : tangente à la paroi en chaque point</translation>
    </message>
    <message>
        <source>Mean deposit</source>
        <translation>Dépôt moyen</translation>
    </message>
    <message>
        <source>Mean layer height</source>
        <translation>Hauteur de couche moyenne</translation>
    </message>
    <message>
        <source>Mean: the mean of the local directions of a layer</source>
        <translation>Moyenne : moyenne des directions locales d’une couche</translation>
    </message>
    <message>
        <source>Medial axis: contours and beads of local width</source>
        <translation>Axe médian : contours et cordons de largeur locale</translation>
    </message>
    <message>
        <source>Mesh edge length</source>
        <translation>Longueur d’arête du maillage</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Mètres</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Milieu</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimètres</translation>
    </message>
    <message>
        <source>Nearest to the end of the bead before</source>
        <translation>Au plus près de la fin du cordon précédent</translation>
    </message>
    <message>
        <source>No ramp: a step of one layer at every seam</source>
        <translation>Sans rampe : une marche d’une couche à chaque début</translation>
    </message>
    <message>
        <source>Nominal layer height</source>
        <translation>Hauteur de couche nominale</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Normal of the plane</source>
        <translation>Normale du plan</translation>
    </message>
    <message>
        <source>Numeric, from the points alone</source>
        <translation>Numérique, des seuls points</translation>
    </message>
    <message>
        <source>One bead without interruption around a thin wall, its height modulated so that it meets both borders.</source>
        <translation>Un cordon sans interruption autour d’une paroi mince, de hauteur modulée pour rejoindre les deux bords.</translation>
    </message>
    <message>
        <source>One line per move, for spreadsheets and for learning to write a post</source>
        <translation>Une ligne par mouvement, pour les tableurs et pour apprendre à écrire un post-processeur</translation>
    </message>
    <message>
        <source>One per layer</source>
        <translation>Un par couche</translation>
    </message>
    <message>
        <source>One per layer and bead</source>
        <translation>Un par couche et cordon</translation>
    </message>
    <message>
        <source>One revolution that climbs from zero</source>
        <translation>Un tour qui monte de zéro</translation>
    </message>
    <message>
        <source>Open beads either way</source>
        <translation>Cordons ouverts dans les deux sens</translation>
    </message>
    <message>
        <source>Order of contours</source>
        <translation>Ordre des contours</translation>
    </message>
    <message>
        <source>Order of islands</source>
        <translation>Ordre des îlots</translation>
    </message>
    <message>
        <source>Order of the pieces</source>
        <translation>Ordre des morceaux</translation>
    </message>
    <message>
        <source>Outer side</source>
        <translation>Côté extérieur</translation>
    </message>
    <message>
        <source>Outer side: the bead lies inside the part</source>
        <translation>Côté extérieur : le cordon est dans la pièce</translation>
    </message>
    <message>
        <source>Outside first</source>
        <translation>Extérieur d’abord</translation>
    </message>
    <message>
        <source>Overlap of closed beads</source>
        <translation>Recouvrement des cordons fermés</translation>
    </message>
    <message>
        <source>Own KRL lines</source>
        <translation>Lignes KRL propres</translation>
    </message>
    <message>
        <source>Own axis</source>
        <translation>Axe propre</translation>
    </message>
    <message>
        <source>Parallel lines, all in one direction</source>
        <translation>Lignes parallèles, toutes dans un sens</translation>
    </message>
    <message>
        <source>Parallel lines, joined at their ends</source>
        <translation>Lignes parallèles, jointes aux extrémités</translation>
    </message>
    <message>
        <source>Parallel planes at a constant step or at adaptive heights, in any build direction; or the substrate&apos;s surface moved up.</source>
        <translation>Plans parallèles à pas constant ou à hauteurs adaptatives, dans toute direction ; ou la surface du substrat déplacée vers le haut.</translation>
    </message>
    <message>
        <source>Parallels of a body of revolution at constant distance, or layers by the parameters of the faces.</source>
        <translation>Parallèles d’un corps de révolution à distance constante, ou couches par les paramètres des faces.</translation>
    </message>
    <message>
        <source>Parameter that climbs</source>
        <translation>Paramètre qui monte</translation>
    </message>
    <message>
        <source>Parameters of the faces</source>
        <translation>Paramètres des faces</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Motif</translation>
    </message>
    <message>
        <source>Piece by piece, the lowest first</source>
        <translation>Morceau par morceau, le plus bas d’abord</translation>
    </message>
    <message>
        <source>Piece by piece, the nearest next</source>
        <translation>Morceau par morceau, le plus proche ensuite</translation>
    </message>
    <message>
        <source>Piece by piece, upwards along each branch</source>
        <translation>Morceau par morceau, en montant chaque branche</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Des plans</translation>
    </message>
    <message>
        <source>Planes across the build direction</source>
        <translation>Plans en travers de la construction</translation>
    </message>
    <message>
        <source>Planes perpendicular to a guide curve, at a constant chord along it.</source>
        <translation>Plans perpendiculaires à une courbe guide, à corde constante.</translation>
    </message>
    <message>
        <source>Point of the axis</source>
        <translation>Point de l’axe</translation>
    </message>
    <message>
        <source>Point of the plane</source>
        <translation>Point du plan</translation>
    </message>
    <message>
        <source>Points on generatrices</source>
        <translation>Points sur les génératrices</translation>
    </message>
    <message>
        <source>Points per revolution</source>
        <translation>Points par tour</translation>
    </message>
    <message>
        <source>Positioner table</source>
        <translation>Plateau du positionneur</translation>
    </message>
    <message>
        <source>Project axes on a plane</source>
        <translation>Projeter les axes sur un plan</translation>
    </message>
    <message>
        <source>Projected cylinder: no overhangs</source>
        <translation>Cylindre projeté : sans surplomb</translation>
    </message>
    <message>
        <source>Propagation of fronts</source>
        <translation>Propagation de fronts</translation>
    </message>
    <message>
        <source>Radius of the torch</source>
        <translation>Rayon de la torche</translation>
    </message>
    <message>
        <source>Ramps as at the start</source>
        <translation>Rampes comme au début</translation>
    </message>
    <message>
        <source>Ramps as the thesis plots them</source>
        <translation>Rampes comme dans la thèse</translation>
    </message>
    <message>
        <source>Ramps inside the range, then no seam step at all</source>
        <translation>Rampes dans le domaine, puis aucune marche</translation>
    </message>
    <message>
        <source>Random, from a seed</source>
        <translation>Aléatoire, d’une graine</translation>
    </message>
    <message>
        <source>Raster: lines in one direction</source>
        <translation>Balayage : lignes dans un sens</translation>
    </message>
    <message>
        <source>Reach of heat</source>
        <translation>Portée de la chaleur</translation>
    </message>
    <message>
        <source>Refuse</source>
        <translation>Refuser</translation>
    </message>
    <message>
        <source>Refuse, with the range that would do</source>
        <translation>Refuser, avec le domaine qui conviendrait</translation>
    </message>
    <message>
        <source>Reported deviation</source>
        <translation>Écart signalé</translation>
    </message>
    <message>
        <source>Revolution</source>
        <translation>Révolution</translation>
    </message>
    <message>
        <source>Revolutions of the change</source>
        <translation>Tours du changement</translation>
    </message>
    <message>
        <source>Robot base</source>
        <translation>Base du robot</translation>
    </message>
    <message>
        <source>Rounding of corners</source>
        <translation>Arrondi des coins</translation>
    </message>
    <message>
        <source>Second mean deposit</source>
        <translation>Second dépôt moyen</translation>
    </message>
    <message>
        <source>Sections that are not closed</source>
        <translation>Sections non fermées</translation>
    </message>
    <message>
        <source>Several upper borders</source>
        <translation>Plusieurs bords supérieurs</translation>
    </message>
    <message>
        <source>Share of distances</source>
        <translation>Part des distances</translation>
    </message>
    <message>
        <source>Shifted by a length from layer to layer</source>
        <translation>Décalés d’une longueur de couche en couche</translation>
    </message>
    <message>
        <source>Shortest paths: least spread of lengths</source>
        <translation>Plus courts chemins : moindre dispersion</translation>
    </message>
    <message>
        <source>Slice all the same and warn</source>
        <translation>Trancher quand même et avertir</translation>
    </message>
    <message>
        <source>Spheres around the origin</source>
        <translation>Sphères autour de l’origine</translation>
    </message>
    <message>
        <source>Spiral: concentric, one bead from outside to inside</source>
        <translation>Spirale : concentrique, un cordon de dehors en dedans</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>Start and end</source>
        <translation>Début et fin</translation>
    </message>
    <message>
        <source>Start angle</source>
        <translation>Angle initial</translation>
    </message>
    <message>
        <source>Start radius</source>
        <translation>Rayon initial</translation>
    </message>
    <message>
        <source>Step measured as</source>
        <translation>Pas mesuré en</translation>
    </message>
    <message>
        <source>Step radius</source>
        <translation>Pas radial</translation>
    </message>
    <message>
        <source>Stop at each</source>
        <translation>Arrêt à chacun</translation>
    </message>
    <message>
        <source>Stop at each (FINE)</source>
        <translation>Arrêt à chacun (FINE)</translation>
    </message>
    <message>
        <source>Straight where it is clear</source>
        <translation>Tout droit où c’est libre</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>Étendue</translation>
    </message>
    <message>
        <source>Takes the path from a table of points instead of slicing the part.</source>
        <translation>Prend la trajectoire d’une table de points au lieu de trancher la pièce.</translation>
    </message>
    <message>
        <source>The bead&apos;s centre</source>
        <translation>Le centre du cordon</translation>
    </message>
    <message>
        <source>The bead&apos;s side: it stays on the surface</source>
        <translation>Le côté du cordon : il reste sur la surface</translation>
    </message>
    <message>
        <source>The borders and cuts of each piece</source>
        <translation>Les bords et coupes de chaque morceau</translation>
    </message>
    <message>
        <source>The distance from the base along the wall</source>
        <translation>La distance à la base le long de la paroi</translation>
    </message>
    <message>
        <source>The substrate&apos;s surface</source>
        <translation>La surface du substrat</translation>
    </message>
    <message>
        <source>Tool axes</source>
        <translation>Axes outil</translation>
    </message>
    <message>
        <source>Up to 36 characters</source>
        <translation>Jusqu’à 36 caractères</translation>
    </message>
    <message>
        <source>Up to 8 characters</source>
        <translation>Jusqu’à 8 caractères</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>Attente</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Parois</translation>
    </message>
    <message>
        <source>Walls only</source>
        <translation>Parois seules</translation>
    </message>
    <message>
        <source>What lies on the part&apos;s surface</source>
        <translation>Ce qui est sur la surface de la pièce</translation>
    </message>
    <message>
        <source>When the range cannot be kept</source>
        <translation>Quand le domaine ne peut être tenu</translation>
    </message>
    <message>
        <source>Where the layer below has cooled longest</source>
        <translation>Où la couche du dessous a refroidi le plus</translation>
    </message>
    <message>
        <source>Wipe</source>
        <translation>Essuyage</translation>
    </message>
    <message>
        <source>With CNT</source>
        <translation>Avec CNT</translation>
    </message>
    <message>
        <source>Within a distance (C_DIS)</source>
        <translation>Dans une distance (C_DIS)</translation>
    </message>
    <message>
        <source>Wrapped</source>
        <translation>Repliées</translation>
    </message>
    <message>
        <source>Zigzag: lines joined along the border</source>
        <translation>Zigzag : lignes jointes le long du bord</translation>
    </message>
    <message>
        <source>cm/min</source>
        <translation>cm/min</translation>
    </message>
    <message>
        <source>mm/sec</source>
        <translation>mm/s</translation>
    </message>
    <message>
        <source>Acceleration of the torch</source>
        <translation>Accélération de la torche</translation>
    </message>
    <message>
        <source>Acceleration time of joints</source>
        <translation>Temps d’accélération des axes</translation>
    </message>
    <message>
        <source>Check collisions</source>
        <translation>Contrôler les collisions</translation>
    </message>
    <message>
        <source>Collision</source>
        <translation>Collision</translation>
    </message>
    <message>
        <source>Effect of joint reversals</source>
        <translation>Effet des inversions d’axes</translation>
    </message>
    <message>
        <source>Greatest lateral tilt</source>
        <translation>Inclinaison latérale maximale</translation>
    </message>
    <message>
        <source>Greatest lead or lag</source>
        <translation>Avance ou retard maximal</translation>
    </message>
    <message>
        <source>Least wire feed</source>
        <translation>Vitesse de fil minimale</translation>
    </message>
    <message>
        <source>Safety distance</source>
        <translation>Distance de sécurité</translation>
    </message>
    <message>
        <source>Smoothness of exit rotations</source>
        <translation>Douceur des rotations d’évitement</translation>
    </message>
    <message>
        <source>Speed prediction</source>
        <translation>Prévision de vitesse</translation>
    </message>
    <message>
        <source>Strategies of single pieces</source>
        <translation>Stratégies par morceau</translation>
    </message>
    <message>
        <source>Tolerance of the speed</source>
        <translation>Tolérance de vitesse</translation>
    </message>
    <message>
        <source>Turn the torch out of collisions</source>
        <translation>Écarter la torche des collisions</translation>
    </message>
    <message>
        <source>Wire feed follows the speed</source>
        <translation>Le fil suit la vitesse</translation>
    </message>
    <message>
        <source>A length further on</source>
        <translation>Une longueur plus loin</translation>
    </message>
    <message>
        <source>Add to what is planned</source>
        <translation>Ajouter à ce qui est prévu</translation>
    </message>
    <message>
        <source>After the bead</source>
        <translation>Après le cordon</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Angle of the table</source>
        <translation>Angle du plateau</translation>
    </message>
    <message>
        <source>As given</source>
        <translation>Comme indiqué</translation>
    </message>
    <message>
        <source>At a length: the bead is cut there</source>
        <translation>À une longueur : le cordon y est coupé</translation>
    </message>
    <message>
        <source>Beads run the other way.</source>
        <translation>Les cordons sont parcourus dans l’autre sens.</translation>
    </message>
    <message>
        <source>Before the bead</source>
        <translation>Avant le cordon</translation>
    </message>
    <message>
        <source>Between two lengths along the bead</source>
        <translation>Entre deux longueurs le long du cordon</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Transition</translation>
    </message>
    <message>
        <source>Builds a range of layers several times, one above the other.</source>
        <translation>Dépose plusieurs fois une suite de couches, l’une sur l’autre.</translation>
    </message>
    <message>
        <source>By a factor of what is planned</source>
        <translation>Par un facteur de ce qui est prévu</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Changement</translation>
    </message>
    <message>
        <source>Change the lateral tilt</source>
        <translation>Changer l’inclinaison latérale</translation>
    </message>
    <message>
        <source>Change the lead angle</source>
        <translation>Changer l’angle d’avance</translation>
    </message>
    <message>
        <source>Change the travel speed</source>
        <translation>Changer la vitesse d’avance</translation>
    </message>
    <message>
        <source>Change the wire feed</source>
        <translation>Changer la vitesse de fil</translation>
    </message>
    <message>
        <source>Close the gap</source>
        <translation>Combler le vide</translation>
    </message>
    <message>
        <source>Closed beads start at another place.</source>
        <translation>Les cordons fermés commencent à un autre endroit.</translation>
    </message>
    <message>
        <source>Constant rotation about the torch</source>
        <translation>Rotation constante autour de la torche</translation>
    </message>
    <message>
        <source>Degree of the polynomial</source>
        <translation>Degré du polynôme</translation>
    </message>
    <message>
        <source>Delete layers</source>
        <translation>Supprimer des couches</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Partout</translation>
    </message>
    <message>
        <source>Exactly there</source>
        <translation>Exactement là</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Facteur</translation>
    </message>
    <message>
        <source>First layer</source>
        <translation>Première couche</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>In a direction from the centre</source>
        <translation>Dans une direction depuis le centre</translation>
    </message>
    <message>
        <source>In a range of layers, a region or a piece of a bead.</source>
        <translation>Dans une suite de couches, une région ou un morceau de cordon.</translation>
    </message>
    <message>
        <source>Inside a box</source>
        <translation>Dans une boîte</translation>
    </message>
    <message>
        <source>Inside a sphere</source>
        <translation>Dans une sphère</translation>
    </message>
    <message>
        <source>Last layer</source>
        <translation>Dernière couche</translation>
    </message>
    <message>
        <source>Leaves out a range of layers, for example what stands already.</source>
        <translation>Omet une suite de couches, par exemple ce qui est déjà construit.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Limit of the cable&apos;s twist</source>
        <translation>Limite de torsion du câble</translation>
    </message>
    <message>
        <source>Move the seam</source>
        <translation>Déplacer les débuts de cordon</translation>
    </message>
    <message>
        <source>Nearest to a point</source>
        <translation>Au plus près d’un point</translation>
    </message>
    <message>
        <source>New start</source>
        <translation>Nouveau départ</translation>
    </message>
    <message>
        <source>Objectives</source>
        <translation>Objectifs</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>Offset of a repetition</source>
        <translation>Décalage d’une répétition</translation>
    </message>
    <message>
        <source>On one side of a plane</source>
        <translation>D’un côté d’un plan</translation>
    </message>
    <message>
        <source>Optimized over the operation</source>
        <translation>Optimisée sur toute l’opération</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Point by point</source>
        <translation>Point par point</translation>
    </message>
    <message>
        <source>Polynomial in each bead</source>
        <translation>Polynôme dans chaque cordon</translation>
    </message>
    <message>
        <source>Positioner at rest</source>
        <translation>Positionneur au repos</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Redundancy</source>
        <translation>Redondance</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Région</translation>
    </message>
    <message>
        <source>Repeat layers</source>
        <translation>Répéter des couches</translation>
    </message>
    <message>
        <source>Repetitions</source>
        <translation>Répétitions</translation>
    </message>
    <message>
        <source>Replace it</source>
        <translation>Le remplacer</translation>
    </message>
    <message>
        <source>Resolution of the joints</source>
        <translation>Résolution des axes</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Inverser</translation>
    </message>
    <message>
        <source>Robot in one plane, torch vertical</source>
        <translation>Robot dans un plan, torche verticale</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Sélection</translation>
    </message>
    <message>
        <source>Table turns evenly along the bead</source>
        <translation>Le plateau tourne régulièrement le long du cordon</translation>
    </message>
    <message>
        <source>Table turns the point to one azimuth</source>
        <translation>Le plateau amène le point à un même azimut</translation>
    </message>
    <message>
        <source>Table turns the tool axis to one azimuth</source>
        <translation>Le plateau amène l’axe outil à un même azimut</translation>
    </message>
    <message>
        <source>The thickness of the range</source>
        <translation>L’épaisseur de la suite de couches</translation>
    </message>
    <message>
        <source>The torch leans forward or back along the travel.</source>
        <translation>La torche penche vers l’avant ou l’arrière de l’avance.</translation>
    </message>
    <message>
        <source>The torch waits with the arc off, for example until a layer is cold.</source>
        <translation>La torche attend, arc éteint, par exemple qu’une couche refroidisse.</translation>
    </message>
    <message>
        <source>The travel speed: the section of the bead stays</source>
        <translation>La vitesse d’avance : la section du cordon reste</translation>
    </message>
    <message>
        <source>The width of the bead</source>
        <translation>La largeur du cordon</translation>
    </message>
    <message>
        <source>The wire feed: the section of the bead stays</source>
        <translation>Le fil : la section du cordon reste</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>To a travel speed</source>
        <translation>À une vitesse d’avance</translation>
    </message>
    <message>
        <source>To a wire feed speed</source>
        <translation>À une vitesse de fil</translation>
    </message>
    <message>
        <source>Tolerance of lead and lateral tilt</source>
        <translation>Tolérance d’avance et d’inclinaison latérale</translation>
    </message>
    <message>
        <source>Turn of the table per bead</source>
        <translation>Rotation du plateau par cordon</translation>
    </message>
    <message>
        <source>Untwisted cable</source>
        <translation>Câble sans torsion</translation>
    </message>
    <message>
        <source>What follows</source>
        <translation>Ce qui suit</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Où</translation>
    </message>
    <message>
        <source>$ADVANCE: moves read ahead.</source>
        <translation>$ADVANCE : mouvements lus d’avance.</translation>
    </message>
    <message>
        <source>$APO.CDIS</source>
        <translation>$APO.CDIS</translation>
    </message>
    <message>
        <source>$APO.CVEL, percent</source>
        <translation>$APO.CVEL, en pour cent</translation>
    </message>
    <message>
        <source>%1 % of the points need a height outside of %2 to %3 mm, by up to %4 mm at (%5, %6, %7)</source>
        <translation>%1 % des points demandent une hauteur hors de %2 à %3 mm, de jusqu’à %4 mm en (%5, %6, %7)</translation>
    </message>
    <message>
        <source>%1 &apos;%2&apos; is used by %3</source>
        <translation>%1 « %2 » : utilisé par %3</translation>
    </message>
    <message>
        <source>%1 &apos;%2&apos; names an unknown %3 &apos;%4&apos;</source>
        <translation>%1 « %2 » nomme un objet inconnu : %3 « %4 »</translation>
    </message>
    <message>
        <source>%1 (no plugin provides %2)</source>
        <translation>%1 (aucune extension ne fournit %2)</translation>
    </message>
    <message>
        <source>%1 (off by %2 %3)</source>
        <translation>%1 (écart de %2 %3)</translation>
    </message>
    <message>
        <source>%1 (position %2)</source>
        <translation>%1 (position %2)</translation>
    </message>
    <message>
        <source>%1 and %2 both write %3</source>
        <translation>%1 et %2 écrivent tous deux %3</translation>
    </message>
    <message>
        <source>%1 axes are perpendicular to the plane that they shall be projected on, and stay as they are</source>
        <translation>%1 axes sont perpendiculaires au plan sur lequel ils doivent être projetés et restent tels quels</translation>
    </message>
    <message>
        <source>%1 beads have no start %2 mm away from the starts of the last %3 layers; the farthest point is used</source>
        <translation>%1 cordons n’ont pas de début à %2 mm des débuts des %3 dernières couches ; le point le plus éloigné est pris</translation>
    </message>
    <message>
        <source>%1 bytes after the last triangle are ignored</source>
        <translation>%1 octets après le dernier triangle sont ignorés</translation>
    </message>
    <message>
        <source>%1 comes within %2 of %3 at %4; the safety distance is %5</source>
        <translation>%1 s’approche à %2 de %3 en %4 ; la distance de sécurité est de %5</translation>
    </message>
    <message>
        <source>%1 comes within %2 of %3 in a travel move, at %4; the safety distance is %5</source>
        <translation>%1 s’approche à %2 de %3 dans un trajet, en %4 ; la distance de sécurité est de %5</translation>
    </message>
    <message>
        <source>%1 contours are not closed and are laid as single beads along the section</source>
        <translation>%1 contours ne sont pas fermés et sont déposés en simples cordons le long de la section</translation>
    </message>
    <message>
        <source>%1 contours are too narrow for half a bead on this side: nothing is deposited there</source>
        <translation>%1 contours sont trop étroits pour un demi-cordon de ce côté : rien n’y est déposé</translation>
    </message>
    <message>
        <source>%1 corners were rounded; there the distance differs from the step by up to %2 mm</source>
        <translation>%1 coins ont été arrondis ; la distance y diffère du pas de jusqu’à %2 mm</translation>
    </message>
    <message>
        <source>%1 edges</source>
        <translation>%1 arêtes</translation>
    </message>
    <message>
        <source>%1 edges do not have one triangle on each side, the first at %2 mm; contours may break there</source>
        <translation>%1 arêtes n’ont pas un triangle de chaque côté, la première en %2 mm ; les contours peuvent y être interrompus</translation>
    </message>
    <message>
        <source>%1 edges of faces without connection were joined</source>
        <translation>%1 arêtes de faces non raccordées ont été jointes</translation>
    </message>
    <message>
        <source>%1 entities of the %2 file break its rules, the first is %3</source>
        <translation>%1 entités du fichier %2 enfreignent ses règles, la première est %3</translation>
    </message>
    <message>
        <source>%1 equal points were joined</source>
        <translation>%1 points égaux ont été réunis</translation>
    </message>
    <message>
        <source>%1 equal points were joined, %2 of them on borders up to %3 mm apart</source>
        <translation>%1 points égaux ont été réunis, dont %2 sur des bords distants de jusqu’à %3 mm</translation>
    </message>
    <message>
        <source>%1 exceeds its limit by up to %2 at %3</source>
        <translation>%1 dépasse sa butée de jusqu’à %2 en %3</translation>
    </message>
    <message>
        <source>%1 faces could not be tessellated and are missing, the first is face %2</source>
        <translation>%1 faces n’ont pu être triangulées et manquent, la première est la face %2</translation>
    </message>
    <message>
        <source>%1 faces were turned so that all normals agree, the first at %2 mm</source>
        <translation>%1 faces ont été retournées pour que toutes les normales s’accordent, la première en %2 mm</translation>
    </message>
    <message>
        <source>%1 failed: %2%3</source>
        <translation>échec : %1 : %2%3</translation>
    </message>
    <message>
        <source>%1 files do not tell their unit; %2 is %3</source>
        <translation>les fichiers %1 n’indiquent pas leur unité ; %2 : %3</translation>
    </message>
    <message>
        <source>%1 finds nothing to change in the %2 layers of the toolpath</source>
        <translation>%1 ne trouve rien à changer dans les %2 couches de la trajectoire</translation>
    </message>
    <message>
        <source>%1 has %2 corners</source>
        <translation>%1 a %2 coins</translation>
    </message>
    <message>
        <source>%1 has %2 instead of a number</source>
        <translation>%1 a %2 au lieu d’un nombre</translation>
    </message>
    <message>
        <source>%1 has a coordinate that is not a number</source>
        <translation>%1 a une coordonnée qui n’est pas un nombre</translation>
    </message>
    <message>
        <source>%1 has a list of impossible length</source>
        <translation>%1 a une liste de longueur impossible</translation>
    </message>
    <message>
        <source>%1 has the same configuration</source>
        <translation>%1 a la même configuration</translation>
    </message>
    <message>
        <source>%1 is &apos;%2&apos;, not a number within %3</source>
        <translation>%1 vaut « %2 », ce n’est pas un nombre entre −%3 et %3</translation>
    </message>
    <message>
        <source>%1 is &apos;%2&apos;, not a whole number from 0</source>
        <translation>%1 vaut « %2 », ce n’est pas un entier à partir de 0</translation>
    </message>
    <message>
        <source>%1 is above the maximum of %2</source>
        <translation>%1 dépasse le maximum de %2</translation>
    </message>
    <message>
        <source>%1 is below the minimum of %2</source>
        <translation>%1 est en dessous du minimum de %2</translation>
    </message>
    <message>
        <source>%1 is negative</source>
        <translation>%1 est négatif</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 n’est pas un nombre</translation>
    </message>
    <message>
        <source>%1 is not finite</source>
        <translation>%1 : valeur non finie</translation>
    </message>
    <message>
        <source>%1 is not known</source>
        <translation>%1 n’est pas connu</translation>
    </message>
    <message>
        <source>%1 is not one of: %2</source>
        <translation>%1 n’est pas parmi : %2</translation>
    </message>
    <message>
        <source>%1 is not part of a facet</source>
        <translation>%1 ne fait pas partie d’une facette</translation>
    </message>
    <message>
        <source>%1 is not part of an OBJ file</source>
        <translation>%1 ne fait pas partie d’un fichier OBJ</translation>
    </message>
    <message>
        <source>%1 is not part of an STL file</source>
        <translation>%1 ne fait pas partie d’un fichier STL</translation>
    </message>
    <message>
        <source>%1 layers grow downwards, the first at (%2, %3, %4)</source>
        <translation>%1 couches croissent vers le bas, la première en (%2, %3, %4)</translation>
    </message>
    <message>
        <source>%1 leaves a gap of %2 mm below a layer that is %3 mm high</source>
        <translation>%1 laisse un vide de %2 mm sous une couche haute de %3 mm</translation>
    </message>
    <message>
        <source>%1 mm² of part %2 run along the planes of the lines and are not covered</source>
        <translation>%1 mm² de la pièce %2 suivent les plans des lignes et ne sont pas couverts</translation>
    </message>
    <message>
        <source>%1 names layers %2 to %3, of which there are %4 to %5</source>
        <translation>%1 nomme les couches %2 à %3 ; il y a celles de %4 à %5</translation>
    </message>
    <message>
        <source>%1 needs the file &apos;%2&apos;, which does not exist (looked for %3)</source>
        <translation>%1 a besoin du fichier « %2 », qui n’existe pas (cherché : %3)</translation>
    </message>
    <message>
        <source>%1 nodes do not have the wanted distance</source>
        <translation>%1 nœuds n’ont pas la distance voulue</translation>
    </message>
    <message>
        <source>%1 nodes of the base curve keep their place on the tessellation</source>
        <translation>%1 nœuds de la courbe de base gardent leur place sur la triangulation</translation>
    </message>
    <message>
        <source>%1 nodes of the layer could not be moved onto the exact surface and keep their place on the tessellation</source>
        <translation>%1 nœuds de la couche n’ont pu être amenés sur la surface exacte et gardent leur place sur la triangulation</translation>
    </message>
    <message>
        <source>%1 out of the robot&apos;s reach; the tool misses up to %2 mm</source>
        <translation>%1 hors de portée du robot ; il manque à l’outil jusqu’à %2 mm</translation>
    </message>
    <message>
        <source>%1 out of the robot&apos;s reach; the tool misses up to %2 mm and %3</source>
        <translation>%1 hors de portée du robot ; il manque à l’outil jusqu’à %2 mm et %3</translation>
    </message>
    <message>
        <source>%1 out of the robot&apos;s reach; the wrist misses up to %2 mm</source>
        <translation>%1 hors de portée du robot ; il manque au poignet jusqu’à %2 mm</translation>
    </message>
    <message>
        <source>%1 out of the robot&apos;s reach; the wrist misses up to %2 mm and %3</source>
        <translation>%1 hors de portée du robot ; il manque au poignet jusqu’à %2 mm et %3</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 points</translation>
    </message>
    <message>
        <source>%1 points get only %2 % or more of the wire that the narrowest bead of their height needs</source>
        <translation>%1 points ne reçoivent que %2 % ou plus du fil que demande le cordon le plus étroit de leur hauteur</translation>
    </message>
    <message>
        <source>%1 points have a layer height outside the process window, worst %2 mm</source>
        <translation>%1 points ont une hauteur de couche hors de la fenêtre du procédé, au pire %2 mm</translation>
    </message>
    <message>
        <source>%1 points lie where planes normal to the guide cross each other</source>
        <translation>%1 points sont là où des plans normaux au guide se croisent</translation>
    </message>
    <message>
        <source>%1 points of the layer do not have the step to the layer below, the worst has %2 mm</source>
        <translation>%1 points de la couche n’ont pas le pas à la couche inférieure, au pire %2 mm</translation>
    </message>
    <message>
        <source>%1 points want a travel speed outside the process window, worst %2 mm/s; the window&apos;s limit is used</source>
        <translation>%1 points demandent une vitesse d’avance hors de la fenêtre du procédé, au pire %2 mm/s ; la limite de la fenêtre est prise</translation>
    </message>
    <message>
        <source>%1 problems:
  %2</source>
        <translation>%1 problèmes :
  %2</translation>
    </message>
    <message>
        <source>%1 refers to a vertex that does not exist</source>
        <translation>%1 renvoie à un sommet qui n’existe pas</translation>
    </message>
    <message>
        <source>%1 repeats layers that turn by %2 degrees; the copies are not turned</source>
        <translation>%1 répète des couches qui tournent de %2 degrés ; les copies ne sont pas tournées</translation>
    </message>
    <message>
        <source>%1 runs up to %2 into %3 at %4</source>
        <translation>%1 pénètre de jusqu’à %2 dans %3 en %4</translation>
    </message>
    <message>
        <source>%1 runs up to %2 into %3 in a travel move, at %4</source>
        <translation>%1 pénètre de jusqu’à %2 dans %3 dans un trajet, en %4</translation>
    </message>
    <message>
        <source>%1 slows the torch down to %2 mm/s (%3 % of the wanted speed) at %4</source>
        <translation>%1 ralentit la torche à %2 mm/s (%3 % de la vitesse voulue) en %4</translation>
    </message>
    <message>
        <source>%1 triangles have no area but connect others and were kept, the first at %2 mm</source>
        <translation>%1 triangles sont sans aire mais en relient d’autres et ont été gardés, le premier en %2 mm</translation>
    </message>
    <message>
        <source>%1 triangles that were there twice were dropped, the first at %2 mm</source>
        <translation>%1 triangles présents deux fois ont été supprimés, le premier en %2 mm</translation>
    </message>
    <message>
        <source>%1 triangles were turned so that all normals agree, the first at %2 mm</source>
        <translation>%1 triangles ont été retournés pour que toutes les normales s’accordent, le premier en %2 mm</translation>
    </message>
    <message>
        <source>%1 triangles without area were dropped, the first at %2 mm</source>
        <translation>%1 triangles sans aire ont été supprimés, le premier en %2 mm</translation>
    </message>
    <message>
        <source>%1 turns by %2 in a travel move</source>
        <translation>%1 tourne de %2 dans un trajet</translation>
    </message>
    <message>
        <source>%1 turns by up to %2 between neighbouring points</source>
        <translation>%1 tourne de jusqu’à %2 entre points voisins</translation>
    </message>
    <message>
        <source>%1 wants the torch to lean by more than 80 degrees at %2 points; it leans by 80 there</source>
        <translation>%1 demande que la torche penche de plus de 80 degrés en %2 points ; elle y penche de 80</translation>
    </message>
    <message>
        <source>%1 wires</source>
        <translation>%1 fils</translation>
    </message>
    <message>
        <source>%1 would make %2 points</source>
        <translation>%1 ferait %2 points</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, ligne %2</translation>
    </message>
    <message>
        <source>%1: %2 step is longer than the others; the longest is %3 s at %4 s instead of %5 s</source>
        <translation>%1 : %2 intervalle est plus long que les autres ; le plus long est de %3 s à %4 s au lieu de %5 s</translation>
    </message>
    <message>
        <source>%1: %2 steps are longer than the others; the longest is %3 s at %4 s instead of %5 s</source>
        <translation>%1 : %2 intervalles sont plus longs que les autres ; le plus long est de %3 s à %4 s au lieu de %5 s</translation>
    </message>
    <message>
        <source>%1: the file &apos;%2&apos; is not the one that the project was made with</source>
        <translation>%1 : le fichier « %2 » n’est pas celui avec lequel le projet a été fait</translation>
    </message>
    <message>
        <source>%1: the path &apos;%2&apos; holds a backslash</source>
        <translation>%1 : le chemin « %2 » contient une barre oblique inverse</translation>
    </message>
    <message>
        <source>%1: the path &apos;%2&apos; is absolute and holds on this machine only</source>
        <translation>%1 : le chemin « %2 » est absolu et ne vaut que sur cette machine</translation>
    </message>
    <message>
        <source>%1: the path &apos;%2&apos; leaves the folder of the project</source>
        <translation>%1 : le chemin « %2 » sort du dossier du projet</translation>
    </message>
    <message>
        <source>%1: the printed axes of %2 are not perpendicular unit vectors; the nearest rotation is used</source>
        <translation>%1 : les axes donnés de %2 ne sont pas des vecteurs unitaires perpendiculaires ; la rotation la plus proche est prise</translation>
    </message>
    <message>
        <source>%1; did you mean &apos;%2&apos;?</source>
        <translation>%1 ; vouliez-vous dire « %2 » ?</translation>
    </message>
    <message>
        <source>%1; it gets no layer</source>
        <translation>%1 ; il ne reçoit pas de couche</translation>
    </message>
    <message>
        <source>%1; there are: %2</source>
        <translation>%1 ; il y a : %2</translation>
    </message>
    <message>
        <source>%1; there is none yet</source>
        <translation>%1 ; il n’y en a pas encore</translation>
    </message>
    <message>
        <source>&apos;%1&apos; appears twice</source>
        <translation>« %1 » apparaît deux fois</translation>
    </message>
    <message>
        <source>&apos;%1&apos; cannot be set: no plugin provides %2</source>
        <translation>« %1 » ne peut être réglé : aucune extension ne fournit %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has more than one meaning</source>
        <translation>« %1 » a plus d’un sens</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has more than one meaning in %2 &apos;%3&apos;</source>
        <translation>« %1 » a plus d’un sens dans %2 « %3 »</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither torch_carried nor part_carried</source>
        <translation>« %1 » n’est ni torch_carried ni part_carried</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither true nor false</source>
        <translation>« %1 » n’est ni true ni false</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no command</source>
        <translation>« %1 » n’est pas une commande</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no id: write 1 to 64 of a-z 0-9 _ - . and begin with a letter or digit</source>
        <translation>« %1 » n’est pas un identifiant : écrire 1 à 64 des caractères a-z 0-9 _ - . en commençant par une lettre ou un chiffre</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no output of the project, and no plugin provides it</source>
        <translation>« %1 » n’est pas une sortie du projet, et aucune extension ne le fournit</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no parameter of this project</source>
        <translation>« %1 » n’est pas un paramètre de ce projet</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no setting</source>
        <translation>« %1 » n’est pas un réglage</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no type of edit</source>
        <translation>« %1 » n’est pas un type de retouche</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no unit of %2</source>
        <translation>« %1 » n’est pas une unité de %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not MAJOR.MINOR, such as 1.0</source>
        <translation>« %1 » n’est pas de la forme MAJEUR.MINEUR, comme 1.0</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not MAJOR.MINOR.PATCH</source>
        <translation>« %1 » n’est pas de la forme MAJEUR.MINEUR.CORRECTIF</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number</source>
        <translation>« %1 » n’est pas un nombre</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a parameter here</source>
        <translation>« %1 » n’est pas un paramètre ici</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a reverse-DNS id: 1 to 64 characters of a-z 0-9 _ - . with at least one dot, such as com.acme.post.demo</source>
        <translation>« %1 » n’est pas un identifiant DNS inversé : 1 à 64 caractères a-z 0-9 _ - . avec au moins un point, comme com.acme.post.demo</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not an integer</source>
        <translation>« %1 » n’est pas un entier</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not one of sphere, capsule, cylinder, box and mesh</source>
        <translation>« %1 » n’est pas parmi sphere, capsule, cylinder, box et mesh</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not one of: %2</source>
        <translation>« %1 » n’est pas parmi : %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not one of: slicing, post</source>
        <translation>« %1 » n’est pas parmi : slicing, post</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not the name of a .so file beside the manifest</source>
        <translation>« %1 » n’est pas le nom d’un fichier .so à côté du manifeste</translation>
    </message>
    <message>
        <source>&apos;%1&apos; names no edit of operation &apos;%2&apos;</source>
        <translation>« %1 » ne nomme aucune retouche de l’opération « %2 »</translation>
    </message>
    <message>
        <source>--set</source>
        <translation>--set</translation>
    </message>
    <message>
        <source>--set %1</source>
        <translation>--set %1</translation>
    </message>
    <message>
        <source>0 does not write it: controllers differ in its meaning.</source>
        <translation>0 ne l’écrit pas : son sens diffère selon les contrôleurs.</translation>
    </message>
    <message>
        <source>0 follows from chord error and spacing.</source>
        <translation>0 : suit de l’erreur de corde et de l’espacement.</translation>
    </message>
    <message>
        <source>0 passes closest to the point, 100 slows down least.</source>
        <translation>0 passe au plus près du point, 100 ralentit le moins.</translation>
    </message>
    <message>
        <source>0 writes none.</source>
        <translation>0 : n’en écrit pas.</translation>
    </message>
    <message>
        <source>0.667 gives a level surface</source>
        <translation>0.667 donne une surface plane</translation>
    </message>
    <message>
        <source>0.667 leaves a level surface (Ding 2015); 1 lays beads side by side.</source>
        <translation>0.667 laisse une surface plane (Ding 2015) ; 1 pose les cordons côte à côte.</translation>
    </message>
    <message>
        <source>0: harmonic field, smoothest. 1: ratio of the distances from the lower and the upper border, most even heights along the wall.</source>
        <translation>0 : champ harmonique, le plus lisse. 1 : rapport des distances aux bords inférieur et supérieur, hauteurs les plus régulières le long de la paroi.</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 point</translation>
    </message>
    <message>
        <source>100 % changes nothing.</source>
        <translation>100 % ne change rien.</translation>
    </message>
    <message>
        <source>A bead on the medial axis where no contour fits, down to the least width.</source>
        <translation>Un cordon sur l’axe médian où aucun contour ne tient, jusqu’à la largeur minimale.</translation>
    </message>
    <message>
        <source>A finding is given where smoothing turns an axis by more.</source>
        <translation>Un constat est donné où le lissage tourne un axe de plus.</translation>
    </message>
    <message>
        <source>A joint whose acceleration is not in the cell file reaches its greatest speed in this time, s; 0 means at once.</source>
        <translation>Un axe dont l’accélération n’est pas dans le fichier de cellule atteint sa vitesse maximale en ce temps, s ; 0 : aussitôt.</translation>
    </message>
    <message>
        <source>A part whose generatrices differ too much needs a wider range.</source>
        <translation>Une pièce dont les génératrices diffèrent trop demande un domaine plus large.</translation>
    </message>
    <message>
        <source>A piece is never built before what it stands on.</source>
        <translation>Un morceau n’est jamais construit avant ce sur quoi il repose.</translation>
    </message>
    <message>
        <source>A point of the axis in the part frame, mm.</source>
        <translation>Un point de l’axe dans le repère pièce, mm.</translation>
    </message>
    <message>
        <source>About the build direction of the layer, from the part&apos;s x axis, seen from the centre of the bead.</source>
        <translation>Autour de la direction de construction de la couche, depuis l’axe x de la pièce, vu du centre du cordon.</translation>
    </message>
    <message>
        <source>Above, the bead humps.</source>
        <translation>Au-dessus, le cordon forme des bosses.</translation>
    </message>
    <message>
        <source>Add %1 %2</source>
        <translation>Ajouter %1 %2</translation>
    </message>
    <message>
        <source>Add edit %1 of %2</source>
        <translation>Ajouter la retouche %1 de %2</translation>
    </message>
    <message>
        <source>Adds COORD to linear and circular moves, so that the speed holds on the turning part (option J601). Needs a positioner as group 2.</source>
        <translation>Ajoute COORD aux mouvements linéaires et circulaires, pour que la vitesse vaille sur la pièce qui tourne (option J601). Demande un positionneur en groupe 2.</translation>
    </message>
    <message>
        <source>Along the bead from its present start; negative lengths run backwards.</source>
        <translation>Le long du cordon depuis son début actuel ; les longueurs négatives vont en arrière.</translation>
    </message>
    <message>
        <source>Angle between build direction and vertical above which a finding is given.</source>
        <translation>Angle entre direction de construction et verticale au-delà duquel un constat est donné.</translation>
    </message>
    <message>
        <source>Angle over which half-planes follow each other.</source>
        <translation>Angle dont les demi-plans se suivent.</translation>
    </message>
    <message>
        <source>As at arc on; {crater} is the crater time in s.</source>
        <translation>Comme à l’allumage ; {crater} est le temps de cratère en s.</translation>
    </message>
    <message>
        <source>At which layer a part with several upper borders reaches each of them.</source>
        <translation>À quelle couche une pièce à plusieurs bords supérieurs atteint chacun d’eux.</translation>
    </message>
    <message>
        <source>Automatic: from inside to outside on medial axes, otherwise from outside.</source>
        <translation>Automatique : de dedans en dehors sur les axes médians, sinon du dehors.</translation>
    </message>
    <message>
        <source>Axes of the file are used where the path&apos;s axis rule is automatic. Numeric axes follow from the neighbouring layers, for files without normals.</source>
        <translation>Les axes du fichier valent où la règle d’axe de la trajectoire est automatique. Les axes numériques suivent des couches voisines, pour les fichiers sans normales.</translation>
    </message>
    <message>
        <source>Axes that lean further from the substrate&apos;s build direction are turned back to this angle, before lead and lateral tilt.</source>
        <translation>Les axes qui penchent plus par rapport à la direction de construction du substrat sont ramenés à cet angle, avant l’angle d’avance et l’inclinaison latérale.</translation>
    </message>
    <message>
        <source>Base: where the torch is with the positioner where it is. Table: in the turning frame of the positioner&apos;s table, for a user frame that the controller turns along.</source>
        <translation>Base : où est la torche, le positionneur étant où il est. Plateau : dans le repère tournant du plateau du positionneur, pour un repère utilisateur que le contrôleur fait tourner avec lui.</translation>
    </message>
    <message>
        <source>Belongs to the range; -1 is the top layer.</source>
        <translation>Fait partie de la suite ; -1 est la couche du dessus.</translation>
    </message>
    <message>
        <source>Beside the range itself; the layers above move up.</source>
        <translation>En plus de la suite elle-même ; les couches du dessus montent.</translation>
    </message>
    <message>
        <source>Between the axis and the direction in which cones grow: 0 gives planes across the axis, 90 cylinders; above 90 the cones open downwards.</source>
        <translation>Entre l’axe et la direction où croissent les cônes : 0 donne des plans en travers de l’axe, 90 des cylindres ; au-delà de 90 les cônes s’ouvrent vers le bas.</translation>
    </message>
    <message>
        <source>Build direction that the torch follows and the positioner turns upright.</source>
        <translation>Direction de construction que la torche suit et que le positionneur redresse.</translation>
    </message>
    <message>
        <source>By how much the lines turn from layer to layer.</source>
        <translation>De combien les lignes tournent d’une couche à l’autre.</translation>
    </message>
    <message>
        <source>Cartesian positions need a robot with 6 joints, this one has %1</source>
        <translation>les positions cartésiennes demandent un robot à 6 axes, celui-ci en a %1</translation>
    </message>
    <message>
        <source>Cartesian positions need an arm; this robot has linear axes</source>
        <translation>les positions cartésiennes demandent un bras ; ce robot a des axes linéaires</translation>
    </message>
    <message>
        <source>Change of a joint between neighbouring points of a bead above which a finding is given.</source>
        <translation>Changement d’un axe entre points voisins d’un cordon au-delà duquel un constat est donné.</translation>
    </message>
    <message>
        <source>Chooses the number of revolutions that brings the mean to the wanted deposit; otherwise as many revolutions as the range allows (Diourté 3.14).</source>
        <translation>Choisit le nombre de tours qui amène la moyenne au dépôt voulu ; sinon autant de tours que le domaine en permet (Diourté 3.14).</translation>
    </message>
    <message>
        <source>Chord of the guide between neighbouring planes (Chalvin A8).</source>
        <translation>Corde du guide entre plans voisins (Chalvin A8).</translation>
    </message>
    <message>
        <source>Chord: the distance between layers is exactly the step. Arc: along the profile.</source>
        <translation>Corde : la distance entre couches est exactement le pas. Arc : le long du profil.</translation>
    </message>
    <message>
        <source>Circles smaller than this are left out: near a pole the beads would overlap.</source>
        <translation>Les cercles plus petits sont omis : près d’un pôle les cordons se recouvriraient.</translation>
    </message>
    <message>
        <source>Constant over the whole operation.</source>
        <translation>Constant sur toute l’opération.</translation>
    </message>
    <message>
        <source>Contours along the border before the pattern begins.</source>
        <translation>Contours le long du bord avant le début du motif.</translation>
    </message>
    <message>
        <source>Contours of the hybrid pattern between walls and zigzag.</source>
        <translation>Contours du motif hybride entre les parois et le zigzag.</translation>
    </message>
    <message>
        <source>Controllers keep 4 decimals of a degree.</source>
        <translation>Les contrôleurs gardent 4 décimales d’un degré.</translation>
    </message>
    <message>
        <source>Depends on the generation of the controller.</source>
        <translation>Dépend de la génération du contrôleur.</translation>
    </message>
    <message>
        <source>Deposit from a height on, reached without a step in the path (smaller, for a cooler end); 0 keeps one deposit.</source>
        <translation>Dépôt à partir d’une hauteur, atteint sans marche dans la trajectoire (plus petit, pour une fin plus froide) ; 0 garde un seul dépôt.</translation>
    </message>
    <message>
        <source>Deposited material in parts of the room, beyond which a finding warns.</source>
        <translation>Matière déposée en parts de la place, au-delà de laquelle un constat avertit.</translation>
    </message>
    <message>
        <source>Direct links are short, but joints that have turned far cannot turn back in them.</source>
        <translation>Les liaisons directes sont courtes, mais les axes qui ont beaucoup tourné ne peuvent y revenir.</translation>
    </message>
    <message>
        <source>Direction from the layer&apos;s centre, about the build direction, from x.</source>
        <translation>Direction depuis le centre de la couche, autour de la direction de construction, à partir de x.</translation>
    </message>
    <message>
        <source>Direction of the lines in the first layer, about the build direction, from the substrate&apos;s x axis.</source>
        <translation>Direction des lignes de la première couche, autour de la direction de construction, à partir de l’axe x du substrat.</translation>
    </message>
    <message>
        <source>Distance along the tool axis at which the torch leaves and meets the bead.</source>
        <translation>Distance le long de l’axe outil à laquelle la torche quitte et rejoint le cordon.</translation>
    </message>
    <message>
        <source>Distance between neighbouring layers along the surface.</source>
        <translation>Distance entre couches voisines le long de la surface.</translation>
    </message>
    <message>
        <source>Distance between neighbouring layers, along the normal.</source>
        <translation>Distance entre couches voisines, le long de la normale.</translation>
    </message>
    <message>
        <source>Distance between neighbouring layers; of half-planes at the step radius.</source>
        <translation>Distance entre couches voisines ; celle des demi-plans au rayon du pas.</translation>
    </message>
    <message>
        <source>Distance between neighbouring planes.</source>
        <translation>Distance entre plans voisins.</translation>
    </message>
    <message>
        <source>Distance between neighbouring planes; with adaptive heights the greatest distance between neighbouring layers.</source>
        <translation>Distance entre plans voisins ; avec des hauteurs adaptatives, la plus grande distance entre couches voisines.</translation>
    </message>
    <message>
        <source>Distance between points of neighbouring layers on the same iso-curve (Chalvin A7, A9).</source>
        <translation>Distance entre points de couches voisines sur la même iso-courbe (Chalvin A7, A9).</translation>
    </message>
    <message>
        <source>Distance from a bead at which its heat has fallen to 37 %.</source>
        <translation>Distance d’un cordon à laquelle sa chaleur est tombée à 37 %.</translation>
    </message>
    <message>
        <source>Distance of every point of a layer to the layer below (Chalvin A11).</source>
        <translation>Distance de chaque point d’une couche à la couche inférieure (Chalvin A11).</translation>
    </message>
    <message>
        <source>Distance of the first layer from the base; 0 puts a layer on the base.</source>
        <translation>Distance de la première couche à la base ; 0 met une couche sur la base.</translation>
    </message>
    <message>
        <source>Else at the nearest point of the bead.</source>
        <translation>Sinon au point le plus proche du cordon.</translation>
    </message>
    <message>
        <source>Empty: the name of the operation.</source>
        <translation>Vide : le nom de l’opération.</translation>
    </message>
    <message>
        <source>Empty: the name of the operation. At most 24 characters.</source>
        <translation>Vide : le nom de l’opération. 24 caractères au plus.</translation>
    </message>
    <message>
        <source>Every other layer runs the other way.</source>
        <translation>Une couche sur deux est parcourue dans l’autre sens.</translation>
    </message>
    <message>
        <source>Factor at the end; linear to 1 over the ramp.</source>
        <translation>Facteur à la fin ; linéaire jusqu’à 1 sur la rampe.</translation>
    </message>
    <message>
        <source>Factor at the start; linear to 1 over the ramp.</source>
        <translation>Facteur au début ; linéaire jusqu’à 1 sur la rampe.</translation>
    </message>
    <message>
        <source>Fineness of the mesh that carries the field; 0 follows from the deposit.</source>
        <translation>Finesse du maillage qui porte le champ ; 0 : suit du dépôt.</translation>
    </message>
    <message>
        <source>Fineness of the mesh that carries the field; 0 follows from the step.</source>
        <translation>Finesse du maillage qui porte le champ ; 0 : suit du pas.</translation>
    </message>
    <message>
        <source>From the start of the bead.</source>
        <translation>Depuis le début du cordon.</translation>
    </message>
    <message>
        <source>Gaps up to this width are closed: between borders of a mesh, and between CAD faces that share no edge. 0 chooses it from the precision of the file.</source>
        <translation>Les fentes jusqu’à cette largeur sont fermées : entre les bords d’un maillage, et entre des faces CAO sans arête commune. 0 la choisit d’après la précision du fichier.</translation>
    </message>
    <message>
        <source>Generatrices modulate the height along curves from border to border (Diourté); the level set follows one field and needs no points per revolution.</source>
        <translation>Les génératrices modulent la hauteur le long de courbes d’un bord à l’autre (Diourté) ; la ligne de niveau suit un champ et n’a pas besoin de points par tour.</translation>
    </message>
    <message>
        <source>Greatest acceleration of the deposition point in the part, mm/s²; 0 sets no limit beside those of the joints.</source>
        <translation>Plus grande accélération du point de dépôt dans la pièce, mm/s² ; 0 ne pose pas de limite en plus de celles des axes.</translation>
    </message>
    <message>
        <source>Greatest change of an exit rotation, degrees per millimetre of the bead.</source>
        <translation>Plus grand changement d’une rotation d’évitement, en degrés par millimètre du cordon.</translation>
    </message>
    <message>
        <source>Greatest distance from a corner at which the controller begins to round it (CNT, C_DIS, zone). 0 stops at every corner.</source>
        <translation>Plus grande distance d’un coin à laquelle le contrôleur commence à l’arrondir (CNT, C_DIS, zone). 0 s’arrête à chaque coin.</translation>
    </message>
    <message>
        <source>Greatest gap between neighbouring shortest paths before a curve is added; 0 takes three times their mean distance.</source>
        <translation>Plus grand écart entre plus courts chemins voisins avant qu’une courbe soit ajoutée ; 0 prend trois fois leur distance moyenne.</translation>
    </message>
    <message>
        <source>Height gained on the way back.</source>
        <translation>Hauteur gagnée pendant le retour.</translation>
    </message>
    <message>
        <source>Height of a direct link above everything deposited below the torch.</source>
        <translation>Hauteur d’une liaison directe au-dessus de tout ce qui est déposé sous la torche.</translation>
    </message>
    <message>
        <source>Height of the first layer above the base; 0 puts a layer on the base itself.</source>
        <translation>Hauteur de la première couche au-dessus de la base ; 0 met une couche sur la base même.</translation>
    </message>
    <message>
        <source>Height of the first layer above the start; 0 puts a layer on the start itself.</source>
        <translation>Hauteur de la première couche au-dessus du début ; 0 met une couche sur le début même.</translation>
    </message>
    <message>
        <source>Height of the first layer above the surface; 0 lays it on the surface itself.</source>
        <translation>Hauteur de la première couche au-dessus de la surface ; 0 la dépose sur la surface même.</translation>
    </message>
    <message>
        <source>Height of travel moves above everything deposited so far.</source>
        <translation>Hauteur des trajets au-dessus de tout ce qui est déjà déposé.</translation>
    </message>
    <message>
        <source>Holds where no height is given and none can be measured.</source>
        <translation>Vaut où aucune hauteur n’est donnée et où aucune ne peut être mesurée.</translation>
    </message>
    <message>
        <source>How beads cover the surface.</source>
        <translation>Comment les cordons couvrent la surface.</translation>
    </message>
    <message>
        <source>How the curves from border to border are found.</source>
        <translation>Comment sont trouvées les courbes d’un bord à l’autre.</translation>
    </message>
    <message>
        <source>How the inside of a layer is filled.</source>
        <translation>Comment l’intérieur d’une couche est rempli.</translation>
    </message>
    <message>
        <source>How the rotation about the torch, the positioner&apos;s axes and the robot&apos;s configuration are chosen. Optimized is never worse than the others by the weights of the objectives.</source>
        <translation>Comment sont choisis la rotation autour de la torche, les axes du positionneur et la configuration du robot. Optimisée n’est jamais moins bonne que les autres selon les poids des objectifs.</translation>
    </message>
    <message>
        <source>How the spiral leaves the border.</source>
        <translation>Comment la spirale quitte le bord.</translation>
    </message>
    <message>
        <source>How the spiral meets the upper border.</source>
        <translation>Comment la spirale rejoint le bord supérieur.</translation>
    </message>
    <message>
        <source>In degrees per mm of path; axes are smoothed until they hold it. 0: no bound.</source>
        <translation>En degrés par mm de trajectoire ; les axes sont lissés jusqu’à la tenir. 0 : sans borne.</translation>
    </message>
    <message>
        <source>In the frame of the part.</source>
        <translation>Dans le repère pièce.</translation>
    </message>
    <message>
        <source>In the frame of the part; beads are cut exactly at its border.</source>
        <translation>Dans le repère pièce ; les cordons sont coupés exactement à sa limite.</translation>
    </message>
    <message>
        <source>In the part frame.</source>
        <translation>Dans le repère pièce.</translation>
    </message>
    <message>
        <source>In the part frame; any length.</source>
        <translation>Dans le repère pièce ; longueur quelconque.</translation>
    </message>
    <message>
        <source>In the substrate&apos;s frame; any length.</source>
        <translation>Dans le repère du substrat ; longueur quelconque.</translation>
    </message>
    <message>
        <source>Inside the window of the process.</source>
        <translation>À l’intérieur de la fenêtre du procédé.</translation>
    </message>
    <message>
        <source>Its sign is the sense.</source>
        <translation>Son signe est le sens.</translation>
    </message>
    <message>
        <source>Joins borders, drops degenerate and duplicate triangles, and turns triangles so that all normals agree.</source>
        <translation>Joint les bords, supprime les triangles dégénérés et doubles, et retourne les triangles pour que toutes les normales s’accordent.</translation>
    </message>
    <message>
        <source>Joint values fix the configuration of the robot; Cartesian positions can be touched up and moved with a user frame.</source>
        <translation>Les valeurs d’axes fixent la configuration du robot ; les positions cartésiennes peuvent être retouchées et déplacées avec un repère utilisateur.</translation>
    </message>
    <message>
        <source>KRL lines take printable ASCII only: &apos;%1&apos;</source>
        <translation>les lignes KRL n’acceptent que l’ASCII imprimable : « %1 »</translation>
    </message>
    <message>
        <source>Keeps the torch from leaning across a plane, for instance towards the substrate.</source>
        <translation>Empêche la torche de pencher en travers d’un plan, par exemple vers le substrat.</translation>
    </message>
    <message>
        <source>Largest angle between the directions of neighbouring edges of the triangles of a CAD part.</source>
        <translation>Plus grand angle entre les directions d’arêtes voisines des triangles d’une pièce CAO.</translation>
    </message>
    <message>
        <source>Largest distance of the triangles from the exact surface of a CAD part. Contours are moved onto the exact surface afterwards.</source>
        <translation>Plus grande distance des triangles à la surface exacte d’une pièce CAO. Les contours sont ensuite amenés sur la surface exacte.</translation>
    </message>
    <message>
        <source>Layers end at a plane: for parts that were made longer than wanted so that their last layers are whole (Chalvin A13).</source>
        <translation>Les couches s’arrêtent à un plan : pour les pièces faites plus longues que voulu pour que leurs dernières couches soient entières (Chalvin A13).</translation>
    </message>
    <message>
        <source>Layers have corners where fronts meet, such as on the outside of a bend. They are rounded so far that the distance between layers differs from the step by at most this; 0 keeps them.</source>
        <translation>Les couches ont des coins où des fronts se rencontrent, comme à l’extérieur d’un coude. Ils sont arrondis tant que la distance entre couches ne diffère du pas que d’au plus cette valeur ; 0 les garde.</translation>
    </message>
    <message>
        <source>Lean of the torch across the travel; positive leans outwards.</source>
        <translation>Inclinaison de la torche en travers de l’avance ; positive vers l’extérieur.</translation>
    </message>
    <message>
        <source>Lean of the torch in the travel plane; positive leans forward.</source>
        <translation>Inclinaison de la torche dans le plan de l’avance ; positive vers l’avant.</translation>
    </message>
    <message>
        <source>Least bend of the stretched or folded elbow.</source>
        <translation>Flexion minimale du coude tendu ou replié.</translation>
    </message>
    <message>
        <source>Least bend of the wrist between axes 4 and 6.</source>
        <translation>Flexion minimale du poignet entre les axes 4 et 6.</translation>
    </message>
    <message>
        <source>Least distance of a start from the starts of the last layers.</source>
        <translation>Distance minimale d’un début aux débuts des dernières couches.</translation>
    </message>
    <message>
        <source>Least distance of the wrist centre from axis 1.</source>
        <translation>Distance minimale du centre du poignet à l’axe 1.</translation>
    </message>
    <message>
        <source>Length along the bead by which the start moves on in each layer.</source>
        <translation>Longueur le long du cordon dont le début avance à chaque couche.</translation>
    </message>
    <message>
        <source>Length along the mean generatrix.</source>
        <translation>Longueur le long de la génératrice moyenne.</translation>
    </message>
    <message>
        <source>Length for which a closed bead runs on over its own start.</source>
        <translation>Longueur dont un cordon fermé continue sur son propre début.</translation>
    </message>
    <message>
        <source>Length from the start of the bead.</source>
        <translation>Longueur depuis le début du cordon.</translation>
    </message>
    <message>
        <source>Length from the start of the bead; 0 is its end.</source>
        <translation>Longueur depuis le début du cordon ; 0 : sa fin.</translation>
    </message>
    <message>
        <source>Length of bead that is deposited until the heat of a bead has fallen to 37 %: travel speed times cooling time.</source>
        <translation>Longueur de cordon déposée jusqu’à ce que la chaleur d’un cordon soit tombée à 37 % : vitesse d’avance fois temps de refroidissement.</translation>
    </message>
    <message>
        <source>Length outside the region in which the change fades away.</source>
        <translation>Longueur hors de la région sur laquelle le changement s’efface.</translation>
    </message>
    <message>
        <source>Length over which travel speed and wire feed change. The heat is least at the start and greatest at the end of a bead.</source>
        <translation>Longueur sur laquelle changent vitesse d’avance et vitesse de fil. La chaleur est la plus faible au début et la plus forte à la fin d’un cordon.</translation>
    </message>
    <message>
        <source>Lines lie in planes normal to it; in the part frame, any length.</source>
        <translation>Les lignes sont dans des plans qui lui sont normaux ; dans le repère pièce, longueur quelconque.</translation>
    </message>
    <message>
        <source>Looks for collisions of torch, robot and positioner with each other, the cell, the substrate and the part as it grows. Needs shapes in the cell file.</source>
        <translation>Cherche les collisions de la torche, du robot et du positionneur entre eux, avec la cellule, le substrat et la pièce en construction. Demande des formes dans le fichier de cellule.</translation>
    </message>
    <message>
        <source>Lower end of the modulation range; 0 takes 90 % of the mean deposit.</source>
        <translation>Bas du domaine de modulation ; 0 prend 90 % du dépôt moyen.</translation>
    </message>
    <message>
        <source>Many controllers read one decimal at most: speeds are then off by up to 0.05 of the unit, which is 0.8 % at 6 mm/sec and 0.14 % at 36 cm/min.</source>
        <translation>Beaucoup de contrôleurs lisent au plus une décimale : les vitesses s’écartent alors de jusqu’à 0.05 de l’unité, soit 0.8 % à 6 mm/s et 0.14 % à 36 cm/min.</translation>
    </message>
    <message>
        <source>Mean height that a revolution adds.</source>
        <translation>Hauteur moyenne qu’un tour ajoute.</translation>
    </message>
    <message>
        <source>Move %1 %2</source>
        <translation>Déplacer %1 %2</translation>
    </message>
    <message>
        <source>Move edit %1 of %2</source>
        <translation>Déplacer la retouche %1 de %2</translation>
    </message>
    <message>
        <source>No layer above this height over the base; 0 slices the whole part.</source>
        <translation>Pas de couche au-dessus de cette hauteur sur la base ; 0 tranche toute la pièce.</translation>
    </message>
    <message>
        <source>No layer above this height over the start; 0 slices the whole part.</source>
        <translation>Pas de couche au-dessus de cette hauteur sur le début ; 0 tranche toute la pièce.</translation>
    </message>
    <message>
        <source>No layer farther from the base than this; 0 slices the whole part.</source>
        <translation>Pas de couche plus loin de la base ; 0 tranche toute la pièce.</translation>
    </message>
    <message>
        <source>Number of layers below whose starts count.</source>
        <translation>Nombre de couches inférieures dont les débuts comptent.</translation>
    </message>
    <message>
        <source>Of $VEL.CP in m/s: 5 decimals are 0.01 mm/s.</source>
        <translation>De $VEL.CP en m/s : 5 décimales font 0.01 mm/s.</translation>
    </message>
    <message>
        <source>Of a single bead; 0 takes the process&apos;s.</source>
        <translation>D’un simple cordon ; 0 prend celle du procédé.</translation>
    </message>
    <message>
        <source>Of an exit rotation, about the direction across the travel.</source>
        <translation>D’une rotation d’évitement, autour de la direction en travers de l’avance.</translation>
    </message>
    <message>
        <source>Of an exit rotation, about the direction of travel.</source>
        <translation>D’une rotation d’évitement, autour de la direction d’avance.</translation>
    </message>
    <message>
        <source>Of beads whose width is chosen; 0: 1.5 bead widths.</source>
        <translation>Des cordons dont la largeur est choisie ; 0 : 1.5 largeur de cordon.</translation>
    </message>
    <message>
        <source>Of beads whose width is chosen; 0: half the bead width.</source>
        <translation>Des cordons dont la largeur est choisie ; 0 : une demi-largeur de cordon.</translation>
    </message>
    <message>
        <source>Of closed beads; open ones stay.</source>
        <translation>Des cordons fermés ; les ouverts restent.</translation>
    </message>
    <message>
        <source>Of degrees, also of axes.</source>
        <translation>Des degrés, aussi des axes.</translation>
    </message>
    <message>
        <source>Of mm and of degrees.</source>
        <translation>Des mm et des degrés.</translation>
    </message>
    <message>
        <source>Of mm.</source>
        <translation>Des mm.</translation>
    </message>
    <message>
        <source>Of positions in mm and speeds in mm/s.</source>
        <translation>Des positions en mm et des vitesses en mm/s.</translation>
    </message>
    <message>
        <source>Of the first half-plane, about the axis.</source>
        <translation>Du premier demi-plan, autour de l’axe.</translation>
    </message>
    <message>
        <source>Of the mesh that carries the layers; 0 chooses it. Points are exact whatever it is; details smaller than it may be passed over.</source>
        <translation>Du maillage qui porte les couches ; 0 la choisit. Les points sont exacts dans tous les cas ; des détails plus petits peuvent échapper.</translation>
    </message>
    <message>
        <source>Of the rotation about the torch.</source>
        <translation>De la rotation autour de la torche.</translation>
    </message>
    <message>
        <source>Of the sphere.</source>
        <translation>De la sphère.</translation>
    </message>
    <message>
        <source>Off: the arc is lit where the bead starts.</source>
        <translation>Non : l’arc est allumé où le cordon commence.</translation>
    </message>
    <message>
        <source>On what the layers lie.</source>
        <translation>Sur quoi sont les couches.</translation>
    </message>
    <message>
        <source>One or several lines separated by &apos;|&apos;, such as the inline forms of ArcTech. {job} is the job number.</source>
        <translation>Une ou plusieurs lignes séparées par « | », comme les formulaires d’ArcTech. {job} est le numéro de job.</translation>
    </message>
    <message>
        <source>Open beads start at the end that is nearer to the bead before.</source>
        <translation>Les cordons ouverts commencent par l’extrémité la plus proche du cordon précédent.</translation>
    </message>
    <message>
        <source>Order, starts and directions of the beads stay as in the file. Otherwise the path&apos;s rules choose them.</source>
        <translation>Ordre, débuts et sens des cordons restent comme dans le fichier. Sinon les règles de la trajectoire les choisissent.</translation>
    </message>
    <message>
        <source>Otherwise layers grow along the substrate&apos;s build direction.</source>
        <translation>Sinon les couches croissent selon la direction de construction du substrat.</translation>
    </message>
    <message>
        <source>Otherwise the axis is found from the surface.</source>
        <translation>Sinon l’axe est trouvé d’après la surface.</translation>
    </message>
    <message>
        <source>Otherwise the process&apos;s width holds.</source>
        <translation>Sinon vaut la largeur du procédé.</translation>
    </message>
    <message>
        <source>Otherwise the z axis of the substrate&apos;s frame.</source>
        <translation>Sinon l’axe z du repère du substrat.</translation>
    </message>
    <message>
        <source>Otherwise they are measured.</source>
        <translation>Sinon elles sont mesurées.</translation>
    </message>
    <message>
        <source>Over how many revolutions the deposit changes.</source>
        <translation>Sur combien de tours le dépôt change.</translation>
    </message>
    <message>
        <source>Over that across it. Above 1 layers bend less towards slanted borders near them and more in the middle of the part.</source>
        <translation>Sur celle en travers. Au-dessus de 1, les couches se courbent moins vers les bords inclinés près d’eux et plus au milieu de la pièce.</translation>
    </message>
    <message>
        <source>Parallels of a body of revolution, or the parameters of the faces of a CAD part. auto takes the first where it fits.</source>
        <translation>Parallèles d’un corps de révolution, ou paramètres des faces d’une pièce CAO. auto prend les premiers où ils conviennent.</translation>
    </message>
    <message>
        <source>Part of each section that beads must cover, else a finding tells the place.</source>
        <translation>Part de chaque section que les cordons doivent couvrir, sinon un constat donne l’endroit.</translation>
    </message>
    <message>
        <source>Part of the greatest joint speed.</source>
        <translation>Part de la vitesse maximale des axes.</translation>
    </message>
    <message>
        <source>Part of the wanted speed by which the predicted speed may be lower or higher before a finding is given.</source>
        <translation>Part de la vitesse voulue dont la vitesse prévue peut être en dessous ou au-dessus avant qu’un constat soit donné.</translation>
    </message>
    <message>
        <source>Part of the wanted wire feed below which it is not lowered.</source>
        <translation>Part de la vitesse de fil voulue en dessous de laquelle elle n’est pas abaissée.</translation>
    </message>
    <message>
        <source>Parts that close in a point: where the bead ends; 0 takes half the deposit.</source>
        <translation>Pièces qui se ferment en un point : où le cordon finit ; 0 prend la moitié du dépôt.</translation>
    </message>
    <message>
        <source>Place of the first layer above the base; 0 puts it on the base.</source>
        <translation>Place de la première couche au-dessus de la base ; 0 la met sur la base.</translation>
    </message>
    <message>
        <source>Place of the first layer above the lower border; 0 puts it on the border.</source>
        <translation>Place de la première couche au-dessus du bord inférieur ; 0 la met sur le bord.</translation>
    </message>
    <message>
        <source>Place of the first plane along the guide; 0 puts it at the guide&apos;s start.</source>
        <translation>Place du premier plan le long du guide ; 0 le met au début du guide.</translation>
    </message>
    <message>
        <source>Planes come nearer where walls lean, so that neighbouring layers are nowhere farther apart than the step, within the layer heights of the process (Chalvin A6).</source>
        <translation>Les plans se rapprochent où les parois penchent, pour que des couches voisines ne soient nulle part plus éloignées que le pas, dans les hauteurs de couche du procédé (Chalvin A6).</translation>
    </message>
    <message>
        <source>Planes, or the surface of the substrate moved up along the build direction.</source>
        <translation>Des plans, ou la surface du substrat déplacée le long de la direction de construction.</translation>
    </message>
    <message>
        <source>Points away from the material that stays; any length.</source>
        <translation>Pointe hors de la matière qui reste ; longueur quelconque.</translation>
    </message>
    <message>
        <source>Positions are written in the robot base frame; another frame than 0 must hold that frame.</source>
        <translation>Les positions sont écrites dans le repère de base du robot ; un repère autre que 0 doit contenir ce repère.</translation>
    </message>
    <message>
        <source>Propagation is exact up to the mesh and keeps the creases where ways from two sides meet; heat rounds them.</source>
        <translation>La propagation est exacte au maillage près et garde les plis où se rencontrent les chemins de deux côtés ; la chaleur les arrondit.</translation>
    </message>
    <message>
        <source>Radius at which half-planes lie one step apart; 0 takes the part&apos;s middle radius.</source>
        <translation>Rayon auquel les demi-plans sont à un pas les uns des autres ; 0 prend le rayon moyen de la pièce.</translation>
    </message>
    <message>
        <source>Ramp at the end</source>
        <translation>Rampe à la fin</translation>
    </message>
    <message>
        <source>Ramp at the start</source>
        <translation>Rampe au début</translation>
    </message>
    <message>
        <source>Ratio of the smallest to the largest singular value of the robot&apos;s linear Jacobian below which a finding is given.</source>
        <translation>Rapport de la plus petite à la plus grande valeur singulière de la jacobienne linéaire du robot en dessous duquel un constat est donné.</translation>
    </message>
    <message>
        <source>Reading CAD file</source>
        <translation>Lecture du fichier CAO</translation>
    </message>
    <message>
        <source>Reading CAD part</source>
        <translation>Lecture de la pièce CAO</translation>
    </message>
    <message>
        <source>Reading file</source>
        <translation>Lecture du fichier</translation>
    </message>
    <message>
        <source>Reading mesh</source>
        <translation>Lecture du maillage</translation>
    </message>
    <message>
        <source>Remove %1 %2</source>
        <translation>Supprimer %1 %2</translation>
    </message>
    <message>
        <source>Remove edit %1 of %2</source>
        <translation>Supprimer la retouche %1 de %2</translation>
    </message>
    <message>
        <source>Rename %1 %2 to %3</source>
        <translation>Renommer %1 %2 en %3</translation>
    </message>
    <message>
        <source>Rename edit %1 of %2</source>
        <translation>Renommer la retouche %1 de %2</translation>
    </message>
    <message>
        <source>Repairing mesh</source>
        <translation>Réparation du maillage</translation>
    </message>
    <message>
        <source>Rounded so that the last layer is the upper border.</source>
        <translation>Arrondi pour que la dernière couche soit le bord supérieur.</translation>
    </message>
    <message>
        <source>Sections smaller than this, in mm², are left out.</source>
        <translation>Les sections plus petites, en mm², sont omises.</translation>
    </message>
    <message>
        <source>Set %1 of %2</source>
        <translation>Régler %1 de %2</translation>
    </message>
    <message>
        <source>Set %1 of %2 %3</source>
        <translation>Régler %1 de %2 %3</translation>
    </message>
    <message>
        <source>Set %1 of edit %2</source>
        <translation>Régler %1 de la retouche %2</translation>
    </message>
    <message>
        <source>Set edit %1 of %2</source>
        <translation>Régler la retouche %1 de %2</translation>
    </message>
    <message>
        <source>Sewing faces</source>
        <translation>Couture des faces</translation>
    </message>
    <message>
        <source>Shorter beads are left out; 0: one bead width.</source>
        <translation>Les cordons plus courts sont omis ; 0 : une largeur de cordon.</translation>
    </message>
    <message>
        <source>Shorter open beads are left out; 0: one bead width.</source>
        <translation>Les cordons ouverts plus courts sont omis ; 0 : une largeur de cordon.</translation>
    </message>
    <message>
        <source>Speed of retract and approach moves.</source>
        <translation>Vitesse des mouvements de retrait et d’approche.</translation>
    </message>
    <message>
        <source>Stabilised width of a wall of one bead.</source>
        <translation>Largeur stabilisée d’une paroi d’un cordon.</translation>
    </message>
    <message>
        <source>Stacked along the surface&apos;s normal.</source>
        <translation>Empilées le long de la normale de la surface.</translation>
    </message>
    <message>
        <source>Standard deviation of joints whose resolution the cell file does not tell.</source>
        <translation>Écart type des axes dont le fichier de cellule n’indique pas la résolution.</translation>
    </message>
    <message>
        <source>Starts lie exactly where the seam asks for, between the points of the contour: a point is put there. Without it the nearest point of the contour is taken and no point is added.</source>
        <translation>Les débuts sont exactement où la règle les demande, entre les points du contour : un point y est mis. Sans cela le point le plus proche du contour est pris et aucun point n’est ajouté.</translation>
    </message>
    <message>
        <source>Step of the torch by the backlash of a joint that turns round above which it is told. Backlash stands in the cell file.</source>
        <translation>Pas de la torche dû au jeu d’un axe qui s’inverse, au-delà duquel il est signalé. Le jeu est dans le fichier de cellule.</translation>
    </message>
    <message>
        <source>Straight run on from the end.</source>
        <translation>Prolongement droit depuis la fin.</translation>
    </message>
    <message>
        <source>Straight run onto the start, along the bead&apos;s tangent.</source>
        <translation>Ligne droite jusqu’au début, selon la tangente du cordon.</translation>
    </message>
    <message>
        <source>Takes the axis of a tube-like part as guide, from its lower to its upper end, instead of a guide of the project.</source>
        <translation>Prend comme guide l’axe d’une pièce en forme de tube, de son bas à son haut, au lieu d’un guide du projet.</translation>
    </message>
    <message>
        <source>Tessellating</source>
        <translation>Triangulation</translation>
    </message>
    <message>
        <source>The field whose saddles cut the part into branches and whose level curves are the layers.</source>
        <translation>Le champ dont les cols coupent la pièce en branches et dont les lignes de niveau sont les couches.</translation>
    </message>
    <message>
        <source>The layer height stays: a faster torch leaves a narrower bead, or more wire.</source>
        <translation>La hauteur de couche reste : une torche plus rapide laisse un cordon plus étroit, ou plus de fil.</translation>
    </message>
    <message>
        <source>The layer height stays: more wire makes a wider bead, or a faster torch.</source>
        <translation>La hauteur de couche reste : plus de fil fait un cordon plus large, ou une torche plus rapide.</translation>
    </message>
    <message>
        <source>The layers above come down by what is gone.</source>
        <translation>Les couches du dessus descendent de ce qui a disparu.</translation>
    </message>
    <message>
        <source>The outermost bead&apos;s outer side, its centre or its inner side.</source>
        <translation>Le côté extérieur du cordon le plus extérieur, son centre ou son côté intérieur.</translation>
    </message>
    <message>
        <source>The same seed gives the same seams.</source>
        <translation>La même graine donne les mêmes débuts.</translation>
    </message>
    <message>
        <source>The three numbers behind the CONFIG letters.</source>
        <translation>Les trois nombres derrière les lettres de CONFIG.</translation>
    </message>
    <message>
        <source>The torch stands lifted, with the arc off.</source>
        <translation>La torche est levée, arc éteint.</translation>
    </message>
    <message>
        <source>The way that the part grows; any length.</source>
        <translation>Le sens dans lequel croît la pièce ; longueur quelconque.</translation>
    </message>
    <message>
        <source>They have no inside. As a bead: the section itself is the path.</source>
        <translation>Elles n’ont pas d’intérieur. En cordon : la section elle-même est la trajectoire.</translation>
    </message>
    <message>
        <source>Third Bryant angle of the tool frame (torch carried) or of the part (part carried), where it is constant; start of point by point.</source>
        <translation>Troisième angle de Bryant du repère outil (torche portée) ou de la pièce (pièce portée), là où il est constant ; départ du point par point.</translation>
    </message>
    <message>
        <source>Three binary digits, such as 010; empty: from the configuration of the cell and the sign of A5.</source>
        <translation>Trois chiffres binaires, comme 010 ; vide : d’après la configuration de la cellule et le signe de A5.</translation>
    </message>
    <message>
        <source>Tilts the torch about the TCP where it would touch the part, smoothly along the bead and within the tolerances; otherwise the findings tell the tilt that would be needed.</source>
        <translation>Penche la torche autour du TCP où elle toucherait la pièce, en douceur le long du cordon et dans les tolérances ; sinon les constats indiquent l’inclinaison qu’il faudrait.</translation>
    </message>
    <message>
        <source>Travel speed at the end</source>
        <translation>Vitesse d’avance à la fin</translation>
    </message>
    <message>
        <source>Travel speed at the start</source>
        <translation>Vitesse d’avance au début</translation>
    </message>
    <message>
        <source>Unit of files that do not tell it (STL, OBJ, PLY, BREP). auto: metres when the part is smaller than 2 units, else millimetres.</source>
        <translation>Unité des fichiers qui ne l’indiquent pas (STL, OBJ, PLY, BREP). auto : mètres quand la pièce est plus petite que 2 unités, sinon millimètres.</translation>
    </message>
    <message>
        <source>Upper end of the modulation range; 0 takes 110 % of the mean deposit.</source>
        <translation>Haut du domaine de modulation ; 0 prend 110 % du dépôt moyen.</translation>
    </message>
    <message>
        <source>Value of the table&apos;s axis at rest (fixed) or at the start of a bead (homogeneous); azimuth in the table&apos;s frame at zero (constant tool axis, fixed tool tip).</source>
        <translation>Valeur de l’axe du plateau au repos (fixed) ou au début d’un cordon (homogeneous) ; azimut dans le repère du plateau à zéro (constant_tool_axis, fixed_tool_tip).</translation>
    </message>
    <message>
        <source>WCAM_PLUGIN_PATH names a folder that does not exist</source>
        <translation>WCAM_PLUGIN_PATH nomme un dossier qui n’existe pas</translation>
    </message>
    <message>
        <source>Wait: the torch stands for the crater time before Arc End. Schedule: the arc end schedule holds the time.</source>
        <translation>Attente : la torche s’arrête pendant le temps de cratère avant Arc End. Programme : le programme de fin d’arc contient le temps.</translation>
    </message>
    <message>
        <source>Wanted height of a layer; with iso-values the mean of each piece, rounded to whole layers.</source>
        <translation>Hauteur voulue d’une couche ; avec les iso-valeurs la moyenne de chaque morceau, arrondie à des couches entières.</translation>
    </message>
    <message>
        <source>Way back over the bead with the arc off.</source>
        <translation>Retour sur le cordon, arc éteint.</translation>
    </message>
    <message>
        <source>What changes the direction.</source>
        <translation>Ce qui change la direction.</translation>
    </message>
    <message>
        <source>What comes nearer gives a warning. Not asked of the material below the nozzle, whose distance is the stick-out.</source>
        <translation>Ce qui vient plus près donne un avertissement. Non demandé à la matière sous la buse, dont la distance est celle du tube contact.</translation>
    </message>
    <message>
        <source>What is higher than a direct link must be this far beside it.</source>
        <translation>Ce qui est plus haut qu’une liaison directe doit être à cette distance à côté d’elle.</translation>
    </message>
    <message>
        <source>What slices a piece instead of the common field: 1=spiral, 3=isovalues; *=spiral for all others. Methods: common, geodesic (distance from the lower end of the piece), isovalues, spiral (one bead; its heights stay inside the process&apos;s range). Pieces count from 0, the lowest first, as the finding slicing.branches lists them.</source>
        <translation>Ce qui tranche un morceau au lieu du champ commun : 1=spiral, 3=isovalues ; *=spiral pour tous les autres. Méthodes : common, geodesic (distance au bas du morceau), isovalues, spiral (un cordon ; ses hauteurs restent dans le domaine du procédé). Les morceaux sont comptés à partir de 0, le plus bas d’abord, comme le constat slicing.branches les énumère.</translation>
    </message>
    <message>
        <source>What spans less than this is a bump, not a branch; 0 takes the step.</source>
        <translation>Ce qui s’étend moins est une bosse, pas une branche ; 0 prend le pas.</translation>
    </message>
    <message>
        <source>Where each closed bead starts and ends.</source>
        <translation>Où chaque cordon fermé commence et finit.</translation>
    </message>
    <message>
        <source>Where the layers begin: the radius of the shaft or core on which they are built (of cones: the distance along the normal from the cone through the origin); 0 takes the part&apos;s nearest point.</source>
        <translation>Où commencent les couches : le rayon de l’arbre ou du noyau sur lequel elles sont construites (pour les cônes : la distance le long de la normale au cône par l’origine) ; 0 prend le point le plus proche de la pièce.</translation>
    </message>
    <message>
        <source>Where the torch is predicted to be slower than wanted, the wire feed is lowered alike. The welding source must allow it.</source>
        <translation>Où la torche est prévue plus lente que voulu, la vitesse de fil est abaissée d’autant. La source de soudage doit le permettre.</translation>
    </message>
    <message>
        <source>Which bead of a layer comes next.</source>
        <translation>Quel cordon d’une couche vient ensuite.</translation>
    </message>
    <message>
        <source>Which side of the bead the part&apos;s surface is. The bead is moved by half its width inside the layer.</source>
        <translation>De quel côté du cordon est la surface de la pièce. Le cordon est déplacé de la moitié de sa largeur dans la couche.</translation>
    </message>
    <message>
        <source>Wire feed at the end</source>
        <translation>Vitesse de fil à la fin</translation>
    </message>
    <message>
        <source>Wire feed at the start</source>
        <translation>Vitesse de fil au début</translation>
    </message>
    <message>
        <source>Wrapped: within 180 degrees to both sides. Continuous: the value next to that of the point before, also beyond 180 degrees.</source>
        <translation>Repliées : à moins de 180 degrés des deux côtés. Continues : la valeur voisine de celle du point précédent, aussi au-delà de 180 degrés.</translation>
    </message>
    <message>
        <source>Writes positions in the frame of the turning table, with $BASE = EK(...): the speed then holds on the part. Without it positions are in the robot base frame.</source>
        <translation>Écrit les positions dans le repère du plateau tournant, avec $BASE = EK(...) : la vitesse vaut alors sur la pièce. Sans cela les positions sont dans le repère de base du robot.</translation>
    </message>
    <message>
        <source>a FANUC motion group has at most 9 axes, the robot has %1</source>
        <translation>un groupe de mouvement FANUC a au plus 9 axes, le robot en a %1</translation>
    </message>
    <message>
        <source>a KUKA program has 6 robot axes and up to 6 external ones, the cell %1 and %2</source>
        <translation>un programme KUKA a 6 axes de robot et jusqu’à 6 externes, la cellule %1 et %2</translation>
    </message>
    <message>
        <source>a KUKA program has rotary robot axes, this robot linear ones</source>
        <translation>un programme KUKA a des axes de robot rotatifs, ce robot des axes linéaires</translation>
    </message>
    <message>
        <source>a bead lies %1 mm or more above everything below it</source>
        <translation>un cordon est à %1 mm ou plus au-dessus de tout ce qui est sous lui</translation>
    </message>
    <message>
        <source>a boolean</source>
        <translation>un booléen</translation>
    </message>
    <message>
        <source>a cell has 1 to %1 joints, not %2 + %3</source>
        <translation>une cellule a de 1 à %1 axes, pas %2 + %3</translation>
    </message>
    <message>
        <source>a closed surface has no border: select the faces of the wall, without the bottom</source>
        <translation>une surface fermée n’a pas de bord : choisir les faces de la paroi, sans le fond</translation>
    </message>
    <message>
        <source>a closed surface without a border does not touch the substrate: its lowest point %1 is %2 mm above it</source>
        <translation>une surface fermée sans bord ne touche pas le substrat : son point le plus bas %1 est %2 mm au-dessus</translation>
    </message>
    <message>
        <source>a command is an object with the keys &apos;command&apos; and &apos;args&apos;</source>
        <translation>une commande est un objet avec les clés « command » et « args »</translation>
    </message>
    <message>
        <source>a coordinate is no number</source>
        <translation>une coordonnée n’est pas un nombre</translation>
    </message>
    <message>
        <source>a document type is not allowed in 3MF</source>
        <translation>un type de document n’est pas permis en 3MF</translation>
    </message>
    <message>
        <source>a face has %1 corners</source>
        <translation>une face a %1 coins</translation>
    </message>
    <message>
        <source>a facet has %1 vertices instead of three</source>
        <translation>une facette a %1 sommets au lieu de trois</translation>
    </message>
    <message>
        <source>a facet has more than three vertices</source>
        <translation>une facette a plus de trois sommets</translation>
    </message>
    <message>
        <source>a fixed value is not a number</source>
        <translation>une valeur imposée n’est pas un nombre</translation>
    </message>
    <message>
        <source>a guide needs at least two points</source>
        <translation>un guide demande au moins deux points</translation>
    </message>
    <message>
        <source>a joint</source>
        <translation>un axe</translation>
    </message>
    <message>
        <source>a joint move with the arc on: its path and speed are not controlled</source>
        <translation>un mouvement d’axes avec l’arc allumé : sa trajectoire et sa vitesse ne sont pas maîtrisées</translation>
    </message>
    <message>
        <source>a joint value</source>
        <translation>une valeur d’axe</translation>
    </message>
    <message>
        <source>a key is not UTF-8 text</source>
        <translation>une clé n’est pas un texte UTF-8</translation>
    </message>
    <message>
        <source>a larger share of distances spreads the heights more evenly, and branches get steps of their own with the strategy for branching parts</source>
        <translation>une plus grande part des distances répartit les hauteurs plus régulièrement, et les branches ont leurs propres pas avec la stratégie pour pièces à branches</translation>
    </message>
    <message>
        <source>a layer or bead mark is left open</source>
        <translation>une marque de couche ou de cordon reste ouverte</translation>
    </message>
    <message>
        <source>a linear or circular move needs a speed above 0</source>
        <translation>un mouvement linéaire ou circulaire demande une vitesse supérieure à 0</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>une liste</translation>
    </message>
    <message>
        <source>a non-manifold edge or vertex at %1, %2, %3</source>
        <translation>une arête ou un sommet non-variété en %1, %2, %3</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>a number is too large</source>
        <translation>un nombre est trop grand</translation>
    </message>
    <message>
        <source>a number is too large for a robot program</source>
        <translation>un nombre est trop grand pour un programme de robot</translation>
    </message>
    <message>
        <source>a number that is not finite cannot be printed</source>
        <translation>un nombre non fini ne peut être imprimé</translation>
    </message>
    <message>
        <source>a number that is not finite cannot be written</source>
        <translation>un nombre non fini ne peut être écrit</translation>
    </message>
    <message>
        <source>a parameter is out of its range</source>
        <translation>un paramètre est hors de son domaine</translation>
    </message>
    <message>
        <source>a part that closes in a point cannot be projected onto a cylinder</source>
        <translation>une pièce qui se ferme en un point ne peut être projetée sur un cylindre</translation>
    </message>
    <message>
        <source>a piece of the part is not joined to the base and gets no layers</source>
        <translation>un morceau de la pièce n’est pas relié à la base et ne reçoit pas de couches</translation>
    </message>
    <message>
        <source>a piece of the part lies below the substrate and gets no layer</source>
        <translation>un morceau de la pièce est sous le substrat et ne reçoit pas de couche</translation>
    </message>
    <message>
        <source>a point has a negative weight</source>
        <translation>un point a un poids négatif</translation>
    </message>
    <message>
        <source>a pose</source>
        <translation>une pose</translation>
    </message>
    <message>
        <source>a pose is not a rotation with a translation</source>
        <translation>une pose n’est pas une rotation avec une translation</translation>
    </message>
    <message>
        <source>a position has %1 joints, the cell %2</source>
        <translation>une position a %1 axes, la cellule %2</translation>
    </message>
    <message>
        <source>a prismatic joint ends somewhere; give its limits</source>
        <translation>un axe prismatique finit quelque part ; donner ses butées</translation>
    </message>
    <message>
        <source>a property without element</source>
        <translation>une propriété sans élément</translation>
    </message>
    <message>
        <source>a second operation &apos;%1&apos; begins</source>
        <translation>une seconde opération « %1 » commence</translation>
    </message>
    <message>
        <source>a speed</source>
        <translation>une vitesse</translation>
    </message>
    <message>
        <source>a speed of %1 mm/s cannot be written to $VEL.CP</source>
        <translation>une vitesse de %1 mm/s ne peut être écrite dans $VEL.CP</translation>
    </message>
    <message>
        <source>a speed of %1 mm/s would be written as 0</source>
        <translation>une vitesse de %1 mm/s serait écrite comme 0</translation>
    </message>
    <message>
        <source>a speed ratio</source>
        <translation>une part de vitesse</translation>
    </message>
    <message>
        <source>a spiral is one bead on one part, and the operation names %1</source>
        <translation>une spirale est un cordon sur une pièce, et l’opération en nomme %1</translation>
    </message>
    <message>
        <source>a spiral needs a part with a single branch: slice it with the strategy for branches, or select the faces of one branch</source>
        <translation>une spirale demande une pièce à une seule branche : la trancher avec la stratégie pour branches, ou choisir les faces d’une branche</translation>
    </message>
    <message>
        <source>a spiral needs a range, such as ±10 % of the mean deposit</source>
        <translation>une spirale demande un domaine, comme ±10 % du dépôt moyen</translation>
    </message>
    <message>
        <source>a spiral needs one border below and at most one above: slice this piece by isovalues</source>
        <translation>une spirale demande un bord en bas et au plus un en haut : trancher ce morceau par iso-valeurs</translation>
    </message>
    <message>
        <source>a spiral runs around a tube or a cap: close slits in the surface, or slice it with open beads</source>
        <translation>une spirale tourne autour d’un tube ou d’une calotte : fermer les fentes de la surface, ou la trancher avec des cordons ouverts</translation>
    </message>
    <message>
        <source>a step between %1 and %2 mm would do</source>
        <translation>un pas entre %1 et %2 mm conviendrait</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texte</translation>
    </message>
    <message>
        <source>a thin wall is modelled by one open surface: select the faces of the wall, without bottom and top</source>
        <translation>une paroi mince est modélisée par une surface ouverte : choisir les faces de la paroi, sans fond ni dessus</translation>
    </message>
    <message>
        <source>a time</source>
        <translation>un temps</translation>
    </message>
    <message>
        <source>a time is negative</source>
        <translation>un temps est négatif</translation>
    </message>
    <message>
        <source>a transaction is open already</source>
        <translation>une transaction est déjà ouverte</translation>
    </message>
    <message>
        <source>a transform does not have twelve numbers</source>
        <translation>une transformation n’a pas douze nombres</translation>
    </message>
    <message>
        <source>a triangle without area at %1, %2, %3</source>
        <translation>un triangle sans aire en %1, %2, %3</translation>
    </message>
    <message>
        <source>a wall stands on one: close the others, or slice the part with the strategy for branches</source>
        <translation>une paroi repose sur un seul : fermer les autres, ou trancher la pièce avec la stratégie pour branches</translation>
    </message>
    <message>
        <source>a welding job has a negative number</source>
        <translation>un job de soudage a un numéro négatif</translation>
    </message>
    <message>
        <source>a wire speed</source>
        <translation>une vitesse de fil</translation>
    </message>
    <message>
        <source>a wire speed is negative</source>
        <translation>une vitesse de fil est négative</translation>
    </message>
    <message>
        <source>adaptive planes</source>
        <translation>plans adaptatifs</translation>
    </message>
    <message>
        <source>add &quot;max_speed&quot; to the joint in the cell file</source>
        <translation>ajouter « max_speed » à l’axe dans le fichier de cellule</translation>
    </message>
    <message>
        <source>add &quot;ratio&quot; to the joint in the cell file</source>
        <translation>ajouter « ratio » à l’axe dans le fichier de cellule</translation>
    </message>
    <message>
        <source>add &quot;ratio&quot; to these joints in the cell file</source>
        <translation>ajouter « ratio » à ces axes dans le fichier de cellule</translation>
    </message>
    <message>
        <source>add a guide to the project (edge, polyline or formula) and name it in the operation, or set automatic_guide</source>
        <translation>ajouter un guide au projet (arête, polyligne ou formule) et le nommer dans l’opération, ou activer automatic_guide</translation>
    </message>
    <message>
        <source>add an operation or enable one</source>
        <translation>ajouter une opération ou en activer une</translation>
    </message>
    <message>
        <source>add the joint speeds to the cell, or set mode=cartesian</source>
        <translation>ajouter les vitesses d’axes à la cellule, ou régler mode=cartesian</translation>
    </message>
    <message>
        <source>adds lengths to angles</source>
        <translation>ajoute des longueurs à des angles</translation>
    </message>
    <message>
        <source>all beads lie below the substrate</source>
        <translation>tous les cordons sont sous le substrat</translation>
    </message>
    <message>
        <source>allow longer names or more points per program</source>
        <translation>permettre des noms plus longs ou plus de points par programme</translation>
    </message>
    <message>
        <source>allow narrower beads (min_width, fill_narrow) or thicken the part</source>
        <translation>permettre des cordons plus étroits (min_width, fill_narrow) ou épaissir la pièce</translation>
    </message>
    <message>
        <source>allow narrower or shorter beads (min_width, min_length)</source>
        <translation>permettre des cordons plus étroits ou plus courts (min_width, min_length)</translation>
    </message>
    <message>
        <source>an automatic guide is the axis of one part, and the operation names %1</source>
        <translation>un guide automatique est l’axe d’une pièce, et l’opération en nomme %1</translation>
    </message>
    <message>
        <source>an edge length of %1 mm would give more than 20 million triangles</source>
        <translation>une longueur d’arête de %1 mm donnerait plus de 20 millions de triangles</translation>
    </message>
    <message>
        <source>an element has no number</source>
        <translation>un élément n’a pas de nombre</translation>
    </message>
    <message>
        <source>an exception of unknown type</source>
        <translation>une exception de type inconnu</translation>
    </message>
    <message>
        <source>an integer</source>
        <translation>un entier</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objet</translation>
    </message>
    <message>
        <source>an operation needs at least one part, or a file with a path</source>
        <translation>une opération demande au moins une pièce, ou un fichier avec une trajectoire</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>angle</translation>
    </message>
    <message>
        <source>angular_speed</source>
        <translation>vitesse angulaire</translation>
    </message>
    <message>
        <source>another %1 has the id &apos;%2&apos; already</source>
        <translation>un autre objet du même type (%1) a déjà l’identifiant « %2 »</translation>
    </message>
    <message>
        <source>another edit of the operation has the id &apos;%1&apos; already</source>
        <translation>une autre retouche de l’opération a déjà l’identifiant « %1 »</translation>
    </message>
    <message>
        <source>another plugin of this id comes first: %1</source>
        <translation>une autre extension de cet identifiant vient d’abord : %1</translation>
    </message>
    <message>
        <source>appears twice</source>
        <translation>apparaît deux fois</translation>
    </message>
    <message>
        <source>approach the first point with a joint move, so that the robot configuration is known</source>
        <translation>approcher le premier point par un mouvement d’axes, pour que la configuration du robot soit connue</translation>
    </message>
    <message>
        <source>area</source>
        <translation>aire</translation>
    </message>
    <message>
        <source>at %1 mm above the surface %2 points run backwards: the surface is hollow with a smaller radius</source>
        <translation>à %1 mm au-dessus de la surface %2 points reculent : la surface est creuse avec un rayon plus petit</translation>
    </message>
    <message>
        <source>at ±%1 % about %2 mm are needed: widen the range, lower the deposit, or start with a simple ramp</source>
        <translation>à ±%1 % il en faut environ %2 mm : élargir le domaine, baisser le dépôt, ou commencer par une simple rampe</translation>
    </message>
    <message>
        <source>auto takes for each face the one that leads away from the base.</source>
        <translation>auto prend pour chaque face celui qui s’éloigne de la base.</translation>
    </message>
    <message>
        <source>automatic guide</source>
        <translation>guide automatique</translation>
    </message>
    <message>
        <source>axes 1 and 2 are not perpendicular</source>
        <translation>les axes 1 et 2 ne sont pas perpendiculaires</translation>
    </message>
    <message>
        <source>axes 2 and 3 are not parallel</source>
        <translation>les axes 2 et 3 ne sont pas parallèles</translation>
    </message>
    <message>
        <source>axes 2 and 3 coincide</source>
        <translation>les axes 2 et 3 coïncident</translation>
    </message>
    <message>
        <source>axes 3 and 4 are not perpendicular</source>
        <translation>les axes 3 et 4 ne sont pas perpendiculaires</translation>
    </message>
    <message>
        <source>axes 4 and 5 are not perpendicular</source>
        <translation>les axes 4 et 5 ne sont pas perpendiculaires</translation>
    </message>
    <message>
        <source>axes 5 and 6 are not perpendicular</source>
        <translation>les axes 5 et 6 ne sont pas perpendiculaires</translation>
    </message>
    <message>
        <source>axis_direction</source>
        <translation>axis_direction</translation>
    </message>
    <message>
        <source>base</source>
        <translation>base</translation>
    </message>
    <message>
        <source>bead width</source>
        <translation>largeur de cordon</translation>
    </message>
    <message>
        <source>beads cover %1 % of the section; the largest void is at %2</source>
        <translation>les cordons couvrent %1 % de la section ; le plus grand vide est en %2</translation>
    </message>
    <message>
        <source>begins with no number of a piece</source>
        <translation>ne commence pas par le numéro d’un morceau</translation>
    </message>
    <message>
        <source>branches</source>
        <translation>branches</translation>
    </message>
    <message>
        <source>build this place on something: another order, a support or another build direction</source>
        <translation>construire cet endroit sur quelque chose : un autre ordre, un support ou une autre direction de construction</translation>
    </message>
    <message>
        <source>bulk slicing</source>
        <translation>tranchage massif</translation>
    </message>
    <message>
        <source>bulk slicing, layer %1</source>
        <translation>tranchage massif, couche %1</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>annulé</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>ne peut être ouvert</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>ne peut être lu : %1</translation>
    </message>
    <message>
        <source>cannot be written%1</source>
        <translation>ne peut être écrit%1</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>ne peut être écrit : %1</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>cellule</translation>
    </message>
    <message>
        <source>cell %1</source>
        <translation>cellule %1</translation>
    </message>
    <message>
        <source>cell %1, operation %2</source>
        <translation>cellule %1, opération %2</translation>
    </message>
    <message>
        <source>cell file %1</source>
        <translation>fichier de cellule %1</translation>
    </message>
    <message>
        <source>change or remove what uses it first</source>
        <translation>changer ou supprimer d’abord ce qui l’utilise</translation>
    </message>
    <message>
        <source>change the formula or its range</source>
        <translation>changer la formule ou son domaine</translation>
    </message>
    <message>
        <source>change the layer step or the strategy so that the distance between layers stays between %1 and %2 mm</source>
        <translation>changer le pas des couches ou la stratégie pour que la distance entre couches reste entre %1 et %2 mm</translation>
    </message>
    <message>
        <source>change the rotation about the torch or the configuration</source>
        <translation>changer la rotation autour de la torche ou la configuration</translation>
    </message>
    <message>
        <source>change the rotation about the torch or the configuration, so that the motion keeps away from a singularity</source>
        <translation>changer la rotation autour de la torche ou la configuration, pour que le mouvement reste loin d’une singularité</translation>
    </message>
    <message>
        <source>change the rotation about the torch or the place of the part</source>
        <translation>changer la rotation autour de la torche ou la place de la pièce</translation>
    </message>
    <message>
        <source>change the rotation about the torch, the configuration or the place of the part</source>
        <translation>changer la rotation autour de la torche, la configuration ou la place de la pièce</translation>
    </message>
    <message>
        <source>change the rotation about the torch, the tool tilt or the place of the part</source>
        <translation>changer la rotation autour de la torche, l’inclinaison de l’outil ou la place de la pièce</translation>
    </message>
    <message>
        <source>change the wire feed speed, the layer step or the window</source>
        <translation>changer la vitesse de fil, le pas des couches ou la fenêtre</translation>
    </message>
    <message>
        <source>check that no wall is modelled as two coincident surfaces</source>
        <translation>vérifier qu’aucune paroi n’est modélisée par deux surfaces confondues</translation>
    </message>
    <message>
        <source>check that the part is a surface with a lower border</source>
        <translation>vérifier que la pièce est une surface avec un bord inférieur</translation>
    </message>
    <message>
        <source>check that the part is complete</source>
        <translation>vérifier que la pièce est complète</translation>
    </message>
    <message>
        <source>check the axis and the part&apos;s place</source>
        <translation>vérifier l’axe et la place de la pièce</translation>
    </message>
    <message>
        <source>check the cables</source>
        <translation>vérifier les câbles</translation>
    </message>
    <message>
        <source>check the folder and its permissions</source>
        <translation>vérifier le dossier et ses droits</translation>
    </message>
    <message>
        <source>check the formulas</source>
        <translation>vérifier les formules</translation>
    </message>
    <message>
        <source>check the formulas and their ranges</source>
        <translation>vérifier les formules et leurs domaines</translation>
    </message>
    <message>
        <source>check the part against the CAD system</source>
        <translation>comparer la pièce avec le système CAO</translation>
    </message>
    <message>
        <source>check the part in the CAD system and export it again</source>
        <translation>vérifier la pièce dans le système CAO et l’exporter de nouveau</translation>
    </message>
    <message>
        <source>check the part&apos;s borders</source>
        <translation>vérifier les bords de la pièce</translation>
    </message>
    <message>
        <source>check the part&apos;s place above the substrate, the build direction and the layer step</source>
        <translation>vérifier la place de la pièce sur le substrat, la direction de construction et le pas des couches</translation>
    </message>
    <message>
        <source>check the path and the permissions</source>
        <translation>vérifier le chemin et les droits</translation>
    </message>
    <message>
        <source>check the permissions</source>
        <translation>vérifier les droits</translation>
    </message>
    <message>
        <source>check the radius and its range</source>
        <translation>vérifier le rayon et son domaine</translation>
    </message>
    <message>
        <source>check the step and the part&apos;s borders</source>
        <translation>vérifier le pas et les bords de la pièce</translation>
    </message>
    <message>
        <source>choose a border or points of the part</source>
        <translation>choisir un bord ou des points de la pièce</translation>
    </message>
    <message>
        <source>choose a direction that lies in the surface</source>
        <translation>choisir une direction contenue dans la surface</translation>
    </message>
    <message>
        <source>choose a folder that you may write to</source>
        <translation>choisir un dossier où l’écriture est permise</translation>
    </message>
    <message>
        <source>choose a guide without cusps</source>
        <translation>choisir un guide sans rebroussement</translation>
    </message>
    <message>
        <source>choose a job of the welding source</source>
        <translation>choisir un job de la source de soudage</translation>
    </message>
    <message>
        <source>choose a larger spacing</source>
        <translation>choisir un espacement plus grand</translation>
    </message>
    <message>
        <source>choose a larger step</source>
        <translation>choisir un pas plus grand</translation>
    </message>
    <message>
        <source>choose a process with a bead as wide as the wall, or lay several beads beside each other</source>
        <translation>choisir un procédé dont le cordon a la largeur de la paroi, ou déposer plusieurs cordons côte à côte</translation>
    </message>
    <message>
        <source>choose a range around the mean deposit</source>
        <translation>choisir un domaine autour du dépôt moyen</translation>
    </message>
    <message>
        <source>choose a range that holds the bead width</source>
        <translation>choisir un domaine qui contient la largeur de cordon</translation>
    </message>
    <message>
        <source>choose a smaller step</source>
        <translation>choisir un pas plus petit</translation>
    </message>
    <message>
        <source>choose a smaller step or first layer, or a later end</source>
        <translation>choisir un pas ou une première couche plus petits, ou une fin plus éloignée</translation>
    </message>
    <message>
        <source>choose a smaller step or start radius</source>
        <translation>choisir un pas ou un rayon initial plus petit</translation>
    </message>
    <message>
        <source>choose a smaller step, or check the part</source>
        <translation>choisir un pas plus petit, ou vérifier la pièce</translation>
    </message>
    <message>
        <source>choose a smaller step, or check the part&apos;s place above the substrate</source>
        <translation>choisir un pas plus petit, ou vérifier la place de la pièce sur le substrat</translation>
    </message>
    <message>
        <source>choose a step inside the range</source>
        <translation>choisir un pas dans le domaine</translation>
    </message>
    <message>
        <source>choose an output of the controller</source>
        <translation>choisir une sortie du contrôleur</translation>
    </message>
    <message>
        <source>choose another axis_plane_normal</source>
        <translation>choisir un autre axis_plane_normal</translation>
    </message>
    <message>
        <source>choose another id</source>
        <translation>choisir un autre identifiant</translation>
    </message>
    <message>
        <source>choose another pattern or line angle, a narrower bead, or a wider range of bead widths</source>
        <translation>choisir un autre motif ou angle des lignes, un cordon plus étroit, ou un domaine de largeurs plus grand</translation>
    </message>
    <message>
        <source>choose another place</source>
        <translation>choisir un autre endroit</translation>
    </message>
    <message>
        <source>choose at least one border</source>
        <translation>choisir au moins un bord</translation>
    </message>
    <message>
        <source>choose borders that do not touch, or give them the same value</source>
        <translation>choisir des bords qui ne se touchent pas, ou leur donner la même valeur</translation>
    </message>
    <message>
        <source>choose the method propagation, or cut the part at the substrate</source>
        <translation>choisir la méthode propagation, ou couper la pièce au substrat</translation>
    </message>
    <message>
        <source>choose the other parameter or another strategy</source>
        <translation>choisir l’autre paramètre ou une autre stratégie</translation>
    </message>
    <message>
        <source>choose wider beads</source>
        <translation>choisir des cordons plus larges</translation>
    </message>
    <message>
        <source>clad the faces one by one, or take the concentric pattern</source>
        <translation>recharger les faces une à une, ou prendre le motif concentrique</translation>
    </message>
    <message>
        <source>clad these faces by an operation of their own, with another direction</source>
        <translation>recharger ces faces par une opération à elles, dans une autre direction</translation>
    </message>
    <message>
        <source>cladding</source>
        <translation>rechargement</translation>
    </message>
    <message>
        <source>cladding, bead spacing</source>
        <translation>rechargement, espacement des cordons</translation>
    </message>
    <message>
        <source>cladding, direction</source>
        <translation>rechargement, direction</translation>
    </message>
    <message>
        <source>cladding, part %1</source>
        <translation>rechargement, pièce %1</translation>
    </message>
    <message>
        <source>close every mark</source>
        <translation>fermer chaque marque</translation>
    </message>
    <message>
        <source>close every mark before the next</source>
        <translation>fermer chaque marque avant la suivante</translation>
    </message>
    <message>
        <source>close holes in the wall, or slice the part with the strategy for branches</source>
        <translation>fermer les trous de la paroi, ou trancher la pièce avec la stratégie pour branches</translation>
    </message>
    <message>
        <source>close the gaps of the part, or give the piece a base of its own</source>
        <translation>fermer les fentes de la pièce, ou donner au morceau sa propre base</translation>
    </message>
    <message>
        <source>column %1: &apos;%2&apos; is not a finite number</source>
        <translation>colonne %1 : « %2 » n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>component &apos;%1&apos; has a version below 1</source>
        <translation>le composant « %1 » a une version inférieure à 1</translation>
    </message>
    <message>
        <source>component &apos;%1&apos; has no factory</source>
        <translation>le composant « %1 » n’a pas de fabrique</translation>
    </message>
    <message>
        <source>component &apos;%1&apos; is registered as %2 but the manifest says %3</source>
        <translation>le composant « %1 » est enregistré comme %2 mais le manifeste dit %3</translation>
    </message>
    <message>
        <source>component &apos;%1&apos; is registered but not named in the manifest</source>
        <translation>le composant « %1 » est enregistré mais absent du manifeste</translation>
    </message>
    <message>
        <source>component &apos;%1&apos; is registered twice</source>
        <translation>le composant « %1 » est enregistré deux fois</translation>
    </message>
    <message>
        <source>component &apos;%1&apos; of the manifest was not registered by the library</source>
        <translation>le composant « %1 » du manifeste n’a pas été enregistré par la bibliothèque</translation>
    </message>
    <message>
        <source>component &apos;%1&apos;: parameter %2</source>
        <translation>composant « %1 » : paramètre %2</translation>
    </message>
    <message>
        <source>conductivity is given for %1 of %2 triangles</source>
        <translation>la conductivité est donnée pour %1 des %2 triangles</translation>
    </message>
    <message>
        <source>configuration &apos;%1&apos; is not one of N/F, U/D, T/B</source>
        <translation>la configuration « %1 » n’est pas parmi N/F, U/D, T/B</translation>
    </message>
    <message>
        <source>contains a folder, a colon or a control character</source>
        <translation>contient un dossier, un deux-points ou un caractère de contrôle</translation>
    </message>
    <message>
        <source>continuous spiral</source>
        <translation>spirale continue</translation>
    </message>
    <message>
        <source>convert it and name it %1</source>
        <translation>la convertir et la nommer %1</translation>
    </message>
    <message>
        <source>copy it beside the cell file, or remove the key</source>
        <translation>le copier à côté du fichier de cellule, ou supprimer la clé</translation>
    </message>
    <message>
        <source>correct the cell</source>
        <translation>corriger la cellule</translation>
    </message>
    <message>
        <source>correct the declaration of the component</source>
        <translation>corriger la déclaration du composant</translation>
    </message>
    <message>
        <source>correct the geometry that the outline comes from</source>
        <translation>corriger la géométrie d’où vient le contour</translation>
    </message>
    <message>
        <source>correct the height range of the process file</source>
        <translation>corriger le domaine de hauteur du fichier de procédé</translation>
    </message>
    <message>
        <source>correct the number in &apos;pieces&apos;, or lower the least branch</source>
        <translation>corriger le numéro dans « pieces », ou réduire la branche minimale</translation>
    </message>
    <message>
        <source>correct the range, or do not declare it as closed</source>
        <translation>corriger le domaine, ou ne pas la déclarer fermée</translation>
    </message>
    <message>
        <source>correct the values and try again</source>
        <translation>corriger les valeurs et réessayer</translation>
    </message>
    <message>
        <source>count layers and beads from 0</source>
        <translation>compter couches et cordons à partir de 0</translation>
    </message>
    <message>
        <source>current</source>
        <translation>courant</translation>
    </message>
    <message>
        <source>cut along a path</source>
        <translation>coupe le long d’un chemin</translation>
    </message>
    <message>
        <source>cut at levels</source>
        <translation>coupe à des niveaux</translation>
    </message>
    <message>
        <source>cut the surface there in the CAD system</source>
        <translation>y couper la surface dans le système CAO</translation>
    </message>
    <message>
        <source>cut_normal</source>
        <translation>cut_normal</translation>
    </message>
    <message>
        <source>density</source>
        <translation>masse volumique</translation>
    </message>
    <message>
        <source>deposit with mode=cartesian</source>
        <translation>déposer avec mode=cartesian</translation>
    </message>
    <message>
        <source>did you mean &apos;%1&apos;?</source>
        <translation>vouliez-vous dire « %1 » ?</translation>
    </message>
    <message>
        <source>did you mean &apos;%1&apos;? %2</source>
        <translation>vouliez-vous dire « %1 » ? %2</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>direction</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>distance</translation>
    </message>
    <message>
        <source>divide the path</source>
        <translation>diviser la trajectoire</translation>
    </message>
    <message>
        <source>does not belong to this configuration</source>
        <translation>n’appartient pas à cette configuration</translation>
    </message>
    <message>
        <source>does not list the kinds of the components</source>
        <translation>n’énumère pas les types des composants</translation>
    </message>
    <message>
        <source>draw a guide yourself</source>
        <translation>dessiner un guide soi-même</translation>
    </message>
    <message>
        <source>draw a guide yourself, or slice the part as a branching one</source>
        <translation>dessiner un guide soi-même, ou trancher la pièce comme une pièce à branches</translation>
    </message>
    <message>
        <source>edge %1 does not exist; the part has %2</source>
        <translation>l’arête %1 n’existe pas ; la pièce en a %2</translation>
    </message>
    <message>
        <source>edges are numbered 0 to %1; `camcli info` lists them</source>
        <translation>les arêtes sont numérotées de 0 à %1 ; « camcli info » les énumère</translation>
    </message>
    <message>
        <source>edit &apos;%1&apos;</source>
        <translation>retouche « %1 »</translation>
    </message>
    <message>
        <source>elbow singularity: the arm is stretched or folded but for %1 at %2</source>
        <translation>singularité du coude : le bras est tendu ou replié à %1 près en %2</translation>
    </message>
    <message>
        <source>element &apos;vertex&apos; has no x, y and z</source>
        <translation>l’élément « vertex » n’a pas x, y et z</translation>
    </message>
    <message>
        <source>end the operation one layer earlier if this is not wanted</source>
        <translation>terminer l’opération une couche plus tôt si ce n’est pas voulu</translation>
    </message>
    <message>
        <source>end the program with arc off</source>
        <translation>finir le programme arc éteint</translation>
    </message>
    <message>
        <source>every line is a JSON object</source>
        <translation>chaque ligne est un objet JSON</translation>
    </message>
    <message>
        <source>every number must be greater than that of box_min: the box is empty</source>
        <translation>chaque nombre doit être plus grand que celui de box_min : la boîte est vide</translation>
    </message>
    <message>
        <source>every size must be greater than 0</source>
        <translation>chaque taille doit être supérieure à 0</translation>
    </message>
    <message>
        <source>exchange height_min and height_max</source>
        <translation>échanger height_min et height_max</translation>
    </message>
    <message>
        <source>exchange speed_min and speed_max</source>
        <translation>échanger speed_min et speed_max</translation>
    </message>
    <message>
        <source>exchange them</source>
        <translation>les échanger</translation>
    </message>
    <message>
        <source>expected %1 initial joint values, got %2</source>
        <translation>%1 valeurs d’axes initiales attendues, %2 reçues</translation>
    </message>
    <message>
        <source>expected %1 motor speeds, got %2</source>
        <translation>%1 vitesses de moteur attendues, %2 reçues</translation>
    </message>
    <message>
        <source>expected %1, got %2</source>
        <translation>attendu : %1, reçu : %2</translation>
    </message>
    <message>
        <source>expected 0, 1 or 2 joints, got %1</source>
        <translation>0, 1 ou 2 axes attendus, %1 reçus</translation>
    </message>
    <message>
        <source>expected 4 rows of 4 numbers, the last row 0 0 0 1</source>
        <translation>4 lignes de 4 nombres attendues, la dernière 0 0 0 1</translation>
    </message>
    <message>
        <source>expected 6 joints (or 5), got %1</source>
        <translation>6 axes (ou 5) attendus, %1 reçus</translation>
    </message>
    <message>
        <source>expected 6 joints, got %1</source>
        <translation>6 axes attendus, %1 reçus</translation>
    </message>
    <message>
        <source>expected [min, max] in %1</source>
        <translation>[min, max] attendu en %1</translation>
    </message>
    <message>
        <source>expected a list of %1 offsets, one per joint</source>
        <translation>liste de %1 décalages attendue, un par axe</translation>
    </message>
    <message>
        <source>expected a list of 1 to %1 components</source>
        <translation>liste de 1 à %1 composants attendue</translation>
    </message>
    <message>
        <source>expected a list of 3 numbers</source>
        <translation>liste de 3 nombres attendue</translation>
    </message>
    <message>
        <source>expected a list of names of frames and shapes</source>
        <translation>liste de noms de repères et de formes attendue</translation>
    </message>
    <message>
        <source>expected a list of shapes, got %1</source>
        <translation>liste de formes attendue, reçu : %1</translation>
    </message>
    <message>
        <source>expected a list of slicing, post</source>
        <translation>liste de slicing, post attendue</translation>
    </message>
    <message>
        <source>expected a list, got %1</source>
        <translation>liste attendue, reçu : %1</translation>
    </message>
    <message>
        <source>expected a number, got %1</source>
        <translation>nombre attendu, reçu : %1</translation>
    </message>
    <message>
        <source>expected a text</source>
        <translation>texte attendu</translation>
    </message>
    <message>
        <source>expected a text, got %1</source>
        <translation>texte attendu, reçu : %1</translation>
    </message>
    <message>
        <source>expected an integer from 0</source>
        <translation>entier à partir de 0 attendu</translation>
    </message>
    <message>
        <source>expected an integer, got %1</source>
        <translation>entier attendu, reçu : %1</translation>
    </message>
    <message>
        <source>expected an object with the vectors x, y and z</source>
        <translation>objet avec les vecteurs x, y et z attendu</translation>
    </message>
    <message>
        <source>expected an object, got %1</source>
        <translation>objet attendu, reçu : %1</translation>
    </message>
    <message>
        <source>expected the index of an edge from 0, or its name</source>
        <translation>indice d’une arête à partir de 0, ou son nom attendu</translation>
    </message>
    <message>
        <source>expected true or false</source>
        <translation>true ou false attendu</translation>
    </message>
    <message>
        <source>export exact geometry, or export the part as STL</source>
        <translation>exporter la géométrie exacte, ou exporter la pièce en STL</translation>
    </message>
    <message>
        <source>export the part again</source>
        <translation>exporter la pièce de nouveau</translation>
    </message>
    <message>
        <source>export the part again; triangles are counted from 0</source>
        <translation>exporter la pièce de nouveau ; les triangles sont comptés à partir de 0</translation>
    </message>
    <message>
        <source>export the part as a solid or as surfaces</source>
        <translation>exporter la pièce en solide ou en surfaces</translation>
    </message>
    <message>
        <source>export the part with a larger tolerance</source>
        <translation>exporter la pièce avec une tolérance plus grande</translation>
    </message>
    <message>
        <source>face %1 (%2%3) has no iso-parametric curves that lead away from the base: those of %4 climb at %5 degrees to the growth direction</source>
        <translation>la face %1 (%2%3) n’a pas de courbes iso-paramétriques qui s’éloignent de la base : celles de %4 montent à %5 degrés de la direction de croissance</translation>
    </message>
    <message>
        <source>face %1 (%2) has no border and is infinite</source>
        <translation>la face %1 (%2) n’a pas de bord et est infinie</translation>
    </message>
    <message>
        <source>face %1 does not exist; the part has %2</source>
        <translation>la face %1 n’existe pas ; la pièce en a %2</translation>
    </message>
    <message>
        <source>face %1 does not exist; the part has faces 0 to %2</source>
        <translation>la face %1 n’existe pas ; la pièce a les faces 0 à %2</translation>
    </message>
    <message>
        <source>face %1 has triangles but no exact surface</source>
        <translation>la face %1 a des triangles mais pas de surface exacte</translation>
    </message>
    <message>
        <source>face selection</source>
        <translation>choix des faces</translation>
    </message>
    <message>
        <source>faces cannot be selected: the part is a mesh</source>
        <translation>les faces ne peuvent être choisies : la pièce est un maillage</translation>
    </message>
    <message>
        <source>failed: %1</source>
        <translation>échec : %1</translation>
    </message>
    <message>
        <source>far more than</source>
        <translation>bien plus de</translation>
    </message>
    <message>
        <source>field</source>
        <translation>champ</translation>
    </message>
    <message>
        <source>files: the project uses no file &apos;%1&apos;</source>
        <translation>files : le projet n’utilise pas de fichier « %1 »</translation>
    </message>
    <message>
        <source>fill</source>
        <translation>remplissage</translation>
    </message>
    <message>
        <source>filling</source>
        <translation>remplissage</translation>
    </message>
    <message>
        <source>fit first_layer and last_layer to the layers that there are</source>
        <translation>ajuster first_layer et last_layer aux couches présentes</translation>
    </message>
    <message>
        <source>fit its layers, bead or region to the present toolpath, or remove it</source>
        <translation>ajuster ses couches, son cordon ou sa région à la trajectoire actuelle, ou la supprimer</translation>
    </message>
    <message>
        <source>format %1 is not known</source>
        <translation>le format %1 n’est pas connu</translation>
    </message>
    <message>
        <source>format version %1 cannot be brought up to date: %2</source>
        <translation>la version de format %1 ne peut être mise à jour : %2</translation>
    </message>
    <message>
        <source>format version %1 is not known</source>
        <translation>la version de format %1 n’est pas connue</translation>
    </message>
    <message>
        <source>format version %1 was read as version %2: %3</source>
        <translation>la version de format %1 a été lue comme version %2 : %3</translation>
    </message>
    <message>
        <source>format_version: expected the integer %1</source>
        <translation>format_version : entier %1 attendu</translation>
    </message>
    <message>
        <source>free some space on the disk and try again</source>
        <translation>libérer de la place sur le disque et réessayer</translation>
    </message>
    <message>
        <source>from and to are the same point; use a sphere</source>
        <translation>from et to sont le même point ; utiliser une sphère</translation>
    </message>
    <message>
        <source>generatrices</source>
        <translation>génératrices</translation>
    </message>
    <message>
        <source>generatrix %1 has no length</source>
        <translation>la génératrice %1 n’a pas de longueur</translation>
    </message>
    <message>
        <source>generatrix %1 is %2 mm long, too short for the start and the end of a spiral</source>
        <translation>la génératrice %1 est longue de %2 mm, trop courte pour le début et la fin d’une spirale</translation>
    </message>
    <message>
        <source>generatrix %1 is %2 mm long, too short for the start of a spiral</source>
        <translation>la génératrice %1 est longue de %2 mm, trop courte pour le début d’une spirale</translation>
    </message>
    <message>
        <source>geodesic distance</source>
        <translation>distance géodésique</translation>
    </message>
    <message>
        <source>give a direction, or leave the three columns out</source>
        <translation>donner une direction, ou omettre les trois colonnes</translation>
    </message>
    <message>
        <source>give a distance in mm</source>
        <translation>donner une distance en mm</translation>
    </message>
    <message>
        <source>give a length, or 0 where it is not known</source>
        <translation>donner une longueur, ou 0 où elle n’est pas connue</translation>
    </message>
    <message>
        <source>give a limit such as 2</source>
        <translation>donner une limite comme 2</translation>
    </message>
    <message>
        <source>give a number from 0</source>
        <translation>donner un nombre à partir de 0</translation>
    </message>
    <message>
        <source>give a range that holds the bead width</source>
        <translation>donner un domaine qui contient la largeur de cordon</translation>
    </message>
    <message>
        <source>give a spacing above 0 mm</source>
        <translation>donner un espacement supérieur à 0 mm</translation>
    </message>
    <message>
        <source>give a step in mm</source>
        <translation>donner un pas en mm</translation>
    </message>
    <message>
        <source>give a step in mm and a turn step in degrees</source>
        <translation>donner un pas en mm et un pas de rotation en degrés</translation>
    </message>
    <message>
        <source>give a table of points with a header line</source>
        <translation>donner une table de points avec une ligne d’en-tête</translation>
    </message>
    <message>
        <source>give a tolerance above 0 mm and a turn from 0</source>
        <translation>donner une tolérance supérieure à 0 mm et un angle à partir de 0</translation>
    </message>
    <message>
        <source>give a tolerance such as 0.01 mm</source>
        <translation>donner une tolérance comme 0.01 mm</translation>
    </message>
    <message>
        <source>give a vector such as [0, 0, 1]</source>
        <translation>donner un vecteur comme [0, 0, 1]</translation>
    </message>
    <message>
        <source>give a vector such as [1, 0, 0]</source>
        <translation>donner un vecteur comme [1, 0, 0]</translation>
    </message>
    <message>
        <source>give a width in mm</source>
        <translation>donner une largeur en mm</translation>
    </message>
    <message>
        <source>give all three or none</source>
        <translation>donner les trois ou aucune</translation>
    </message>
    <message>
        <source>give at least one vertex, point, curve or border edge</source>
        <translation>donner au moins un sommet, un point, une courbe ou une arête de bord</translation>
    </message>
    <message>
        <source>give begin &lt; end</source>
        <translation>donner begin &lt; end</translation>
    </message>
    <message>
        <source>give each border a finite value</source>
        <translation>donner à chaque bord une valeur finie</translation>
    </message>
    <message>
        <source>give each operation a table of its own</source>
        <translation>donner à chaque opération sa propre table</translation>
    </message>
    <message>
        <source>give h_min and h_max as positive heights</source>
        <translation>donner h_min et h_max, des hauteurs positives</translation>
    </message>
    <message>
        <source>give one list of values per part</source>
        <translation>donner une liste de valeurs par pièce</translation>
    </message>
    <message>
        <source>give one per triangle or none</source>
        <translation>en donner une par triangle ou aucune</translation>
    </message>
    <message>
        <source>give one value per joint, the robot&apos;s first</source>
        <translation>donner une valeur par axe, ceux du robot d’abord</translation>
    </message>
    <message>
        <source>give one value per vertex of the part&apos;s mesh</source>
        <translation>donner une valeur par sommet du maillage de la pièce</translation>
    </message>
    <message>
        <source>give the axis, or use another strategy</source>
        <translation>donner l’axe, ou utiliser une autre stratégie</translation>
    </message>
    <message>
        <source>give the operation a toolpath</source>
        <translation>donner une trajectoire à l’opération</translation>
    </message>
    <message>
        <source>give the right axis, or use another strategy</source>
        <translation>donner le bon axe, ou utiliser une autre stratégie</translation>
    </message>
    <message>
        <source>give the width of a single bead in mm</source>
        <translation>donner la largeur d’un simple cordon en mm</translation>
    </message>
    <message>
        <source>give vertices, points and edges of this mesh</source>
        <translation>donner des sommets, points et arêtes de ce maillage</translation>
    </message>
    <message>
        <source>gives a matrix beside other parts; keep the matrix alone</source>
        <translation>donne une matrice à côté d’autres parties ; garder la matrice seule</translation>
    </message>
    <message>
        <source>gives its rotation more than once; keep one of wpr, abc, bryant, axes</source>
        <translation>donne sa rotation plus d’une fois ; garder une seule de wpr, abc, bryant, axes</translation>
    </message>
    <message>
        <source>guessed: the largest extent is %1, at least 2 units</source>
        <translation>deviné : la plus grande dimension est %1, au moins 2 unités</translation>
    </message>
    <message>
        <source>guessed: the largest extent is %1, less than 2 units</source>
        <translation>deviné : la plus grande dimension est %1, moins de 2 unités</translation>
    </message>
    <message>
        <source>guide</source>
        <translation>guide</translation>
    </message>
    <message>
        <source>guide &apos;%1&apos;</source>
        <translation>guide « %1 »</translation>
    </message>
    <message>
        <source>guide formula</source>
        <translation>formule de guide</translation>
    </message>
    <message>
        <source>h_min (%1 mm) is above h_max (%2 mm)</source>
        <translation>h_min (%1 mm) est au-dessus de h_max (%2 mm)</translation>
    </message>
    <message>
        <source>half-edge %1 does not exist</source>
        <translation>la demi-arête %1 n’existe pas</translation>
    </message>
    <message>
        <source>has %1 triangles, more than can be handled</source>
        <translation>a %1 triangles, plus qu’il n’en peut être traité</translation>
    </message>
    <message>
        <source>has a format_version other than 1</source>
        <translation>a un format_version autre que 1</translation>
    </message>
    <message>
        <source>has a negative height or width at point %1</source>
        <translation>a une hauteur ou une largeur négative au point %1</translation>
    </message>
    <message>
        <source>has a number that is not finite at point %1</source>
        <translation>a un nombre non fini au point %1</translation>
    </message>
    <message>
        <source>has an unknown key &quot;%1&quot;</source>
        <translation>a une clé inconnue « %1 »</translation>
    </message>
    <message>
        <source>has limits and is endless; keep one</source>
        <translation>a des butées et est sans fin ; garder l’un des deux</translation>
    </message>
    <message>
        <source>has no &apos;=&apos;</source>
        <translation>n’a pas de « = »</translation>
    </message>
    <message>
        <source>has no direction; give a vector that is not zero</source>
        <translation>n’a pas de direction ; donner un vecteur non nul</translation>
    </message>
    <message>
        <source>has revolutions that do not ascend inside its points</source>
        <translation>a des tours qui ne croissent pas parmi ses points</translation>
    </message>
    <message>
        <source>hatching</source>
        <translation>hachurage</translation>
    </message>
    <message>
        <source>header line %1: %2</source>
        <translation>ligne d’en-tête %1 : %2</translation>
    </message>
    <message>
        <source>import</source>
        <translation>import</translation>
    </message>
    <message>
        <source>import another file</source>
        <translation>importer un autre fichier</translation>
    </message>
    <message>
        <source>import the part from STEP, IGES or BREP</source>
        <translation>importer la pièce de STEP, IGES ou BREP</translation>
    </message>
    <message>
        <source>index: the list has only %1 entries</source>
        <translation>index : la liste n’a que %1 entrées</translation>
    </message>
    <message>
        <source>insets</source>
        <translation>contours intérieurs</translation>
    </message>
    <message>
        <source>install the plugin; `camcli plugins list` shows what there is</source>
        <translation>installer l’extension ; « camcli plugins list » montre ce qu’il y a</translation>
    </message>
    <message>
        <source>is a folder, not a file</source>
        <translation>est un dossier, pas un fichier</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>est vide</translation>
    </message>
    <message>
        <source>is longer than %1 bytes</source>
        <translation>est plus long que %1 octets</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>manque</translation>
    </message>
    <message>
        <source>is neither revolute nor prismatic, but &apos;%1&apos;</source>
        <translation>n’est ni revolute ni prismatic, mais « %1 »</translation>
    </message>
    <message>
        <source>is no argument of this command</source>
        <translation>n’est pas un argument de cette commande</translation>
    </message>
    <message>
        <source>is not UTF-8 text</source>
        <translation>n’est pas un texte UTF-8</translation>
    </message>
    <message>
        <source>is not a %1 file: it does not start like one</source>
        <translation>n’est pas un fichier %1 : il ne commence pas comme tel</translation>
    </message>
    <message>
        <source>is not a file name</source>
        <translation>n’est pas un nom de fichier</translation>
    </message>
    <message>
        <source>is not a finite number</source>
        <translation>n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>is not a key of a manifest</source>
        <translation>n’est pas une clé d’un manifeste</translation>
    </message>
    <message>
        <source>is not a key of a manifest; did you mean &apos;%1&apos;?</source>
        <translation>n’est pas une clé d’un manifeste ; vouliez-vous dire « %1 » ?</translation>
    </message>
    <message>
        <source>is not a parameter here</source>
        <translation>n’est pas un paramètre ici</translation>
    </message>
    <message>
        <source>is not a parameter here; did you mean &apos;%1&apos;?</source>
        <translation>n’est pas un paramètre ici ; vouliez-vous dire « %1 » ?</translation>
    </message>
    <message>
        <source>is not an object</source>
        <translation>n’est pas un objet</translation>
    </message>
    <message>
        <source>is not known here</source>
        <translation>n’est pas connu ici</translation>
    </message>
    <message>
        <source>is not known here (notes go into &quot;comment&quot; or keys that begin with x-)</source>
        <translation>n’est pas connu ici (les notes vont dans « comment » ou dans des clés qui commencent par x-)</translation>
    </message>
    <message>
        <source>is not known here; did you mean &apos;%1&apos;?</source>
        <translation>n’est pas connu ici ; vouliez-vous dire « %1 » ?</translation>
    </message>
    <message>
        <source>is not known here; did you mean &apos;%1&apos;? (notes go into &quot;comment&quot; or keys that begin with x-)</source>
        <translation>n’est pas connu ici ; vouliez-vous dire « %1 » ? (les notes vont dans « comment » ou dans des clés qui commencent par x-)</translation>
    </message>
    <message>
        <source>is not one of: slicing, post</source>
        <translation>n’est pas parmi : slicing, post</translation>
    </message>
    <message>
        <source>is not the name of a joint</source>
        <translation>n’est pas le nom d’un axe</translation>
    </message>
    <message>
        <source>is not the name of a joint before this one</source>
        <translation>n’est pas le nom d’un axe avant celui-ci</translation>
    </message>
    <message>
        <source>is too short for an STL file (%1 bytes)</source>
        <translation>est trop court pour un fichier STL (%1 octets)</translation>
    </message>
    <message>
        <source>iso-parametric slicing</source>
        <translation>tranchage iso-paramétrique</translation>
    </message>
    <message>
        <source>it has no border to stand on</source>
        <translation>il n’a pas de bord sur lequel reposer</translation>
    </message>
    <message>
        <source>it has no manifest %1 beside it</source>
        <translation>il n’a pas de manifeste %1 à côté de lui</translation>
    </message>
    <message>
        <source>it has several borders at one end</source>
        <translation>il a plusieurs bords à une extrémité</translation>
    </message>
    <message>
        <source>it is kept in the file and has no effect</source>
        <translation>il est gardé dans le fichier et n’a pas d’effet</translation>
    </message>
    <message>
        <source>it is of kind %1; %2</source>
        <translation>il est du type %1 ; %2</translation>
    </message>
    <message>
        <source>it was built for plugin ABI %1, this program has %2; install a newer WCAM or an older plugin</source>
        <translation>elle a été faite pour l’ABI d’extension %1, ce programme a %2 ; installer un WCAM plus récent ou une extension plus ancienne</translation>
    </message>
    <message>
        <source>it was built for plugin ABI %1, this program has %2; rebuild the plugin</source>
        <translation>elle a été faite pour l’ABI d’extension %1, ce programme a %2 ; recompiler l’extension</translation>
    </message>
    <message>
        <source>it was built with C++ ABI &apos;%1&apos;, this program with &apos;%2&apos;; build it with the same compiler and options</source>
        <translation>elle a été faite avec l’ABI C++ « %1 », ce programme avec « %2 » ; la compiler avec le même compilateur et les mêmes options</translation>
    </message>
    <message>
        <source>its component &apos;%1&apos; is already provided by plugin %2 (%3)</source>
        <translation>son composant « %1 » est déjà fourni par l’extension %2 (%3)</translation>
    </message>
    <message>
        <source>its descriptor has %1 bytes instead of %2</source>
        <translation>son descripteur a %1 octets au lieu de %2</translation>
    </message>
    <message>
        <source>its descriptor has no register function</source>
        <translation>son descripteur n’a pas de fonction d’enregistrement</translation>
    </message>
    <message>
        <source>its entry point failed: %1</source>
        <translation>son point d’entrée a échoué : %1</translation>
    </message>
    <message>
        <source>its entry point returned no descriptor</source>
        <translation>son point d’entrée n’a pas rendu de descripteur</translation>
    </message>
    <message>
        <source>its library %1 does not exist</source>
        <translation>sa bibliothèque %1 n’existe pas</translation>
    </message>
    <message>
        <source>its library cannot be loaded: %1</source>
        <translation>sa bibliothèque ne peut être chargée : %1</translation>
    </message>
    <message>
        <source>its library cannot be loaded: the file is not a 64-bit ELF library</source>
        <translation>sa bibliothèque ne peut être chargée : le fichier n’est pas une bibliothèque ELF 64 bits</translation>
    </message>
    <message>
        <source>its library cannot be loaded: the file is shorter than its header says</source>
        <translation>sa bibliothèque ne peut être chargée : le fichier est plus court que ne dit son en-tête</translation>
    </message>
    <message>
        <source>its path comes from a file</source>
        <translation>sa trajectoire vient d’un fichier</translation>
    </message>
    <message>
        <source>its register function failed: %1</source>
        <translation>sa fonction d’enregistrement a échoué : %1</translation>
    </message>
    <message>
        <source>join the piece to the others, or slice it as a part of its own</source>
        <translation>relier le morceau aux autres, ou le trancher comme une pièce à part</translation>
    </message>
    <message>
        <source>joint %1</source>
        <translation>axe %1</translation>
    </message>
    <message>
        <source>joint %1 has no greatest speed</source>
        <translation>l’axe %1 n’a pas de vitesse maximale</translation>
    </message>
    <message>
        <source>joint %1 of the robot is prismatic</source>
        <translation>l’axe %1 du robot est prismatique</translation>
    </message>
    <message>
        <source>joint %1 turns round; its backlash moves the torch by %2 mm</source>
        <translation>l’axe %1 s’inverse ; son jeu déplace la torche de %2 mm</translation>
    </message>
    <message>
        <source>keep one</source>
        <translation>en garder un</translation>
    </message>
    <message>
        <source>key: must not be empty</source>
        <translation>key : ne doit pas être vide</translation>
    </message>
    <message>
        <source>lacks &quot;%1&quot;</source>
        <translation>n’a pas « %1 »</translation>
    </message>
    <message>
        <source>layer %1</source>
        <translation>couche %1</translation>
    </message>
    <message>
        <source>layer %1 contour %2 %3</source>
        <translation>couche %1 contour %2 %3</translation>
    </message>
    <message>
        <source>layer %1 has a number that is not finite</source>
        <translation>la couche %1 a un nombre non fini</translation>
    </message>
    <message>
        <source>layer %1, bead %2 follows layer %3, bead %4</source>
        <translation>couche %1, cordon %2 suit couche %3, cordon %4</translation>
    </message>
    <message>
        <source>layer and bead marks do not nest</source>
        <translation>les marques de couche et de cordon ne s’emboîtent pas</translation>
    </message>
    <message>
        <source>layers that follow the distance from the base keep the height best</source>
        <translation>les couches qui suivent la distance à la base tiennent le mieux la hauteur</translation>
    </message>
    <message>
        <source>leave out one of the edits that delete layers</source>
        <translation>ôter une des retouches qui suppriment des couches</translation>
    </message>
    <message>
        <source>length</source>
        <translation>longueur</translation>
    </message>
    <message>
        <source>let the length of the path lead the motion, not an axis</source>
        <translation>laisser la longueur de la trajectoire mener le mouvement, pas un axe</translation>
    </message>
    <message>
        <source>let the robot carry the part (cell &quot;%1&quot;), configuration %2</source>
        <translation>faire porter la pièce au robot (cellule « %1 »), configuration %2</translation>
    </message>
    <message>
        <source>let the robot carry the torch (cell &quot;%1&quot;), configuration %2</source>
        <translation>faire porter la torche au robot (cellule « %1 »), configuration %2</translation>
    </message>
    <message>
        <source>levels</source>
        <translation>niveaux</translation>
    </message>
    <message>
        <source>line %1 is not three numbers</source>
        <translation>la ligne %1 n’est pas formée de trois nombres</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>ligne %1 : %2</translation>
    </message>
    <message>
        <source>line %1: a zero byte</source>
        <translation>ligne %1 : un octet nul</translation>
    </message>
    <message>
        <source>looked in: %1</source>
        <translation>cherché dans : %1</translation>
    </message>
    <message>
        <source>loop %1, point %2</source>
        <translation>boucle %1, point %2</translation>
    </message>
    <message>
        <source>lower count or the range of layers</source>
        <translation>diminuer count ou la suite de couches</translation>
    </message>
    <message>
        <source>lower seam_keep_away or seam_memory</source>
        <translation>diminuer seam_keep_away ou seam_memory</translation>
    </message>
    <message>
        <source>lower the part by that much, or select an open working surface (faces) of it</source>
        <translation>abaisser la pièce d’autant, ou en choisir une surface de travail ouverte (des faces)</translation>
    </message>
    <message>
        <source>lower the speed or raise the wire feed in the edit, or let the other follow</source>
        <translation>baisser la vitesse ou augmenter la vitesse de fil dans la retouche, ou laisser l’autre suivre</translation>
    </message>
    <message>
        <source>lower the tessellation&apos;s chord tolerance</source>
        <translation>réduire la tolérance de corde de la triangulation</translation>
    </message>
    <message>
        <source>lower the tessellation&apos;s chord tolerance, or move the layers off tangent faces</source>
        <translation>réduire la tolérance de corde de la triangulation, ou écarter les couches des faces tangentes</translation>
    </message>
    <message>
        <source>lower the travel speed, smooth the path (axis_rate bounds the turn of its build direction), or keep away from singularities</source>
        <translation>baisser la vitesse d’avance, lisser la trajectoire (axis_rate borne la rotation de sa direction de construction), ou rester loin des singularités</translation>
    </message>
    <message>
        <source>make one operation per part</source>
        <translation>faire une opération par pièce</translation>
    </message>
    <message>
        <source>make one operation per piece: select the faces of one of them</source>
        <translation>faire une opération par morceau : choisir les faces de l’un d’eux</translation>
    </message>
    <message>
        <source>medial axis</source>
        <translation>axe médian</translation>
    </message>
    <message>
        <source>min_width</source>
        <translation>min_width</translation>
    </message>
    <message>
        <source>min_width, max_width</source>
        <translation>min_width, max_width</translation>
    </message>
    <message>
        <source>more than %1 points</source>
        <translation>plus de %1 points</translation>
    </message>
    <message>
        <source>more than 100 000 lines would be needed</source>
        <translation>il faudrait plus de 100 000 lignes</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>mouvement</translation>
    </message>
    <message>
        <source>move the axis beside the part</source>
        <translation>déplacer l’axe à côté de la pièce</translation>
    </message>
    <message>
        <source>move the part by %1 mm in %2 of the table</source>
        <translation>déplacer la pièce de %1 mm en %2 du plateau</translation>
    </message>
    <message>
        <source>move the part in the cell file instead: T_table_part</source>
        <translation>déplacer plutôt la pièce dans le fichier de cellule : T_table_part</translation>
    </message>
    <message>
        <source>move the part in the cell, change the rotation about the torch or the configuration, or lower the safe height when only travel moves are concerned</source>
        <translation>déplacer la pièce dans la cellule, changer la rotation autour de la torche ou la configuration, ou baisser la hauteur de sécurité quand seuls des trajets sont concernés</translation>
    </message>
    <message>
        <source>move the part onto the substrate, or a little into it</source>
        <translation>déplacer la pièce sur le substrat, ou un peu dedans</translation>
    </message>
    <message>
        <source>move the part or the substrate</source>
        <translation>déplacer la pièce ou le substrat</translation>
    </message>
    <message>
        <source>move the part or the substrate if this is not wanted</source>
        <translation>déplacer la pièce ou le substrat si ce n’est pas voulu</translation>
    </message>
    <message>
        <source>move the part or the substrate, or extend the part below the substrate so that it is cut there</source>
        <translation>déplacer la pièce ou le substrat, ou prolonger la pièce sous le substrat pour qu’elle y soit coupée</translation>
    </message>
    <message>
        <source>move the positioner by %1 mm in %2 of the base</source>
        <translation>déplacer le positionneur de %1 mm en %2 de la base</translation>
    </message>
    <message>
        <source>move the torch by %1 mm in %2 of the base</source>
        <translation>déplacer la torche de %1 mm en %2 de la base</translation>
    </message>
    <message>
        <source>move to the start point first</source>
        <translation>aller d’abord au point de départ</translation>
    </message>
    <message>
        <source>must be &quot;wcam-project&quot;; this file is no WCAM project</source>
        <translation>doit être « wcam-project » ; ce fichier n’est pas un projet WCAM</translation>
    </message>
    <message>
        <source>must be 1 or -1</source>
        <translation>doit être 1 ou -1</translation>
    </message>
    <message>
        <source>must be an integer from 0</source>
        <translation>doit être un entier à partir de 0</translation>
    </message>
    <message>
        <source>must be empty or 64 lower-case hexadecimal digits</source>
        <translation>doit être vide ou fait de 64 chiffres hexadécimaux en minuscules</translation>
    </message>
    <message>
        <source>must be greater than 0</source>
        <translation>doit être supérieur à 0</translation>
    </message>
    <message>
        <source>must be greater than 0 in all three directions</source>
        <translation>doit être supérieur à 0 dans les trois directions</translation>
    </message>
    <message>
        <source>must be greater than begin</source>
        <translation>doit être supérieur à begin</translation>
    </message>
    <message>
        <source>must be greater than from, or 0 for the end</source>
        <translation>doit être supérieur à from, ou 0 pour la fin</translation>
    </message>
    <message>
        <source>must have 1 to %1 characters and no control characters</source>
        <translation>doit avoir de 1 à %1 caractères et pas de caractère de contrôle</translation>
    </message>
    <message>
        <source>n of $OUT[n].</source>
        <translation>n de $OUT[n].</translation>
    </message>
    <message>
        <source>n of Arc End[n]; 0: the job number of the process.</source>
        <translation>n de Arc End[n] ; 0 : le numéro de job du procédé.</translation>
    </message>
    <message>
        <source>n of Arc Start[n]; 0: the job number of the process.</source>
        <translation>n de Arc Start[n] ; 0 : le numéro de job du procédé.</translation>
    </message>
    <message>
        <source>n of MACHINE_DEF[n].</source>
        <translation>n de MACHINE_DEF[n].</translation>
    </message>
    <message>
        <source>name at least one face</source>
        <translation>nommer au moins une face</translation>
    </message>
    <message>
        <source>name the columns %1; others begin with x-</source>
        <translation>nommer les colonnes %1 ; les autres commencent par x-</translation>
    </message>
    <message>
        <source>name the edge by its index; `camcli info` lists them</source>
        <translation>nommer l’arête par son indice ; « camcli info » les énumère</translation>
    </message>
    <message>
        <source>name world, base, a joint, flange, tcp or table</source>
        <translation>nommer world, base, un axe, flange, tcp ou table</translation>
    </message>
    <message>
        <source>names a piece twice</source>
        <translation>nomme un morceau deux fois</translation>
    </message>
    <message>
        <source>names no method</source>
        <translation>ne nomme pas de méthode</translation>
    </message>
    <message>
        <source>names of %1 characters have no room for %2 numbered programs</source>
        <translation>les noms de %1 caractères n’ont pas la place pour %2 programmes numérotés</translation>
    </message>
    <message>
        <source>names part %1, which does not exist</source>
        <translation>nomme la pièce %1, qui n’existe pas</translation>
    </message>
    <message>
        <source>names, kinds and speeds of joints must be given for all joints or for none</source>
        <translation>noms, types et vitesses d’axes doivent être donnés pour tous les axes ou pour aucun</translation>
    </message>
    <message>
        <source>needs &quot;limits&quot;: [min, max] in %1</source>
        <translation>demande « limits » : [min, max] en %1</translation>
    </message>
    <message>
        <source>needs &quot;limits&quot;: [min, max] in %1 or &quot;endless&quot;: true</source>
        <translation>demande « limits » : [min, max] en %1 ou « endless » : true</translation>
    </message>
    <message>
        <source>needs &quot;minimal&quot; or &quot;frenet&quot; for &quot;frame&quot;</source>
        <translation>demande « minimal » ou « frenet » pour « frame »</translation>
    </message>
    <message>
        <source>needs a text for &quot;%1&quot;</source>
        <translation>demande un texte pour « %1 »</translation>
    </message>
    <message>
        <source>needs an ascending range for &quot;%1&quot;</source>
        <translation>demande un domaine croissant pour « %1 »</translation>
    </message>
    <message>
        <source>needs at least one piece of &quot;radius&quot;</source>
        <translation>demande au moins un morceau de « radius »</translation>
    </message>
    <message>
        <source>needs numbers or formulas for &quot;%1&quot;</source>
        <translation>demande des nombres ou des formules pour « %1 »</translation>
    </message>
    <message>
        <source>needs true or false for &quot;%1&quot;</source>
        <translation>demande true ou false pour « %1 »</translation>
    </message>
    <message>
        <source>needs two numbers for &quot;%1&quot;</source>
        <translation>demande deux nombres pour « %1 »</translation>
    </message>
    <message>
        <source>nested deeper than 200 levels</source>
        <translation>imbriqué sur plus de 200 niveaux</translation>
    </message>
    <message>
        <source>no bead fits into any section</source>
        <translation>aucun cordon ne tient dans une section</translation>
    </message>
    <message>
        <source>no bead fits into the section at %1 mm</source>
        <translation>aucun cordon ne tient dans la section à %1 mm</translation>
    </message>
    <message>
        <source>no bead fits onto the surface</source>
        <translation>aucun cordon ne tient sur la surface</translation>
    </message>
    <message>
        <source>no face is selected</source>
        <translation>aucune face n’est choisie</translation>
    </message>
    <message>
        <source>no joint</source>
        <translation>aucun axe</translation>
    </message>
    <message>
        <source>no layer fits between the start at %1 and the part&apos;s end at %2</source>
        <translation>aucune couche ne tient entre le début à %1 et la fin de la pièce à %2</translation>
    </message>
    <message>
        <source>no layer fits on the part</source>
        <translation>aucune couche ne tient sur la pièce</translation>
    </message>
    <message>
        <source>no layer meets the part</source>
        <translation>aucune couche ne rencontre la pièce</translation>
    </message>
    <message>
        <source>no pipe: %1</source>
        <translation>pas de tube : %1</translation>
    </message>
    <message>
        <source>no plane section of the part is closed</source>
        <translation>aucune section plane de la pièce n’est fermée</translation>
    </message>
    <message>
        <source>no plugin provides the post-processor &apos;%1&apos;</source>
        <translation>aucune extension ne fournit le post-processeur « %1 »</translation>
    </message>
    <message>
        <source>no plugin provides the strategy &apos;%1&apos;</source>
        <translation>aucune extension ne fournit la stratégie « %1 »</translation>
    </message>
    <message>
        <source>no revolution meets the part</source>
        <translation>aucun tour ne rencontre la pièce</translation>
    </message>
    <message>
        <source>no triangle is left after dropping those without area</source>
        <translation>aucun triangle ne reste après suppression de ceux sans aire</translation>
    </message>
    <message>
        <source>no triangle is left after joining the borders</source>
        <translation>aucun triangle ne reste après la jonction des bords</translation>
    </message>
    <message>
        <source>no vertex has a fixed value</source>
        <translation>aucun sommet n’a de valeur imposée</translation>
    </message>
    <message>
        <source>no vertex is a source</source>
        <translation>aucun sommet n’est une source</translation>
    </message>
    <message>
        <source>no way leads from the lower border to the upper limit</source>
        <translation>aucun chemin ne mène du bord inférieur à la limite supérieure</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>none of the %1 faces could be tessellated%2</source>
        <translation>aucune des %1 faces n’a pu être triangulée%2</translation>
    </message>
    <message>
        <source>none of these alone puts it right: rotations about the torch, the other configurations, tilts within the tolerances, turning the part, moving part or positioner by up to %1 mm, the cell&apos;s other configuration; search a placement with `camcli place`</source>
        <translation>rien de cela seul n’y remédie : rotations autour de la torche, autres configurations, inclinaisons dans les tolérances, rotation de la pièce, déplacement de la pièce ou du positionneur de jusqu’à %1 mm, autre configuration de la cellule ; chercher une place avec « camcli place »</translation>
    </message>
    <message>
        <source>none of these alone puts it right: rotations about the torch, the other configurations, tilts within the tolerances, turning the part, moving part or positioner by up to %1 mm; search a placement with `camcli place`</source>
        <translation>rien de cela seul n’y remédie : rotations autour de la torche, autres configurations, inclinaisons dans les tolérances, rotation de la pièce, déplacement de la pièce ou du positionneur de jusqu’à %1 mm ; chercher une place avec « camcli place »</translation>
    </message>
    <message>
        <source>none of these alone puts it right: rotations about the torch, the other configurations, tilts within the tolerances; change the axes of the path, the shape of the torch or the order of the beads</source>
        <translation>rien de cela seul n’y remédie : rotations autour de la torche, autres configurations, inclinaisons dans les tolérances ; changer les axes de la trajectoire, la forme de la torche ou l’ordre des cordons</translation>
    </message>
    <message>
        <source>not JSON</source>
        <translation>n’est pas du JSON</translation>
    </message>
    <message>
        <source>nowhere</source>
        <translation>nulle part</translation>
    </message>
    <message>
        <source>null</source>
        <translation>null</translation>
    </message>
    <message>
        <source>number</source>
        <translation>nombre</translation>
    </message>
    <message>
        <source>numbers have a decimal point and no unit</source>
        <translation>les nombres ont un point décimal et pas d’unité</translation>
    </message>
    <message>
        <source>object</source>
        <translation>objet</translation>
    </message>
    <message>
        <source>obstacle %1</source>
        <translation>obstacle %1</translation>
    </message>
    <message>
        <source>offset</source>
        <translation>décalage</translation>
    </message>
    <message>
        <source>on %1 % of the surface of part %2 lines lie clearly nearer than the bead distance, since the surface slopes differently along them</source>
        <translation>sur %1 % de la surface de la pièce %2 les lignes sont nettement plus proches que l’espacement des cordons, car la surface y est inclinée différemment</translation>
    </message>
    <message>
        <source>one bead of %1 revolutions, %2 to %3 mm deposit; generatrices of %4 to %5 mm</source>
        <translation>un cordon de %1 tours, %2 à %3 mm de dépôt ; génératrices de %4 à %5 mm</translation>
    </message>
    <message>
        <source>one bead of %1 revolutions, %2 to %3 mm deposit; mean generatrix %4 mm</source>
        <translation>un cordon de %1 tours, %2 à %3 mm de dépôt ; génératrice moyenne de %4 mm</translation>
    </message>
    <message>
        <source>only a part of the columns %1, %2, %3 is there</source>
        <translation>seule une partie des colonnes %1, %2, %3 est présente</translation>
    </message>
    <message>
        <source>open it with the newer version of WCAM</source>
        <translation>l’ouvrir avec la version plus récente de WCAM</translation>
    </message>
    <message>
        <source>operation</source>
        <translation>opération</translation>
    </message>
    <message>
        <source>operation &apos;%1&apos;</source>
        <translation>opération « %1 »</translation>
    </message>
    <message>
        <source>operation &apos;%1&apos; has no edit &apos;%2&apos;</source>
        <translation>l’opération « %1 » n’a pas de retouche « %2 »</translation>
    </message>
    <message>
        <source>operations: %1</source>
        <translation>opérations : %1</translation>
    </message>
    <message>
        <source>order the rows by layer, bead and point</source>
        <translation>ordonner les lignes par couche, cordon et point</translation>
    </message>
    <message>
        <source>output</source>
        <translation>sortie</translation>
    </message>
    <message>
        <source>output &apos;%1&apos;</source>
        <translation>sortie « %1 »</translation>
    </message>
    <message>
        <source>output &apos;%1&apos;, operation &apos;%2&apos;</source>
        <translation>sortie « %1 », opération « %2 »</translation>
    </message>
    <message>
        <source>output file name &apos;%1&apos; %2</source>
        <translation>nom de fichier de sortie « %1 » : %2</translation>
    </message>
    <message>
        <source>output file name &apos;%1&apos; appears twice (case is ignored)</source>
        <translation>le nom de fichier de sortie « %1 » apparaît deux fois (sans égard à la casse)</translation>
    </message>
    <message>
        <source>outputs</source>
        <translation>sorties</translation>
    </message>
    <message>
        <source>outputs are counted from 1</source>
        <translation>les sorties sont comptées à partir de 1</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>recouvrement</translation>
    </message>
    <message>
        <source>parameter %1</source>
        <translation>paramètre %1</translation>
    </message>
    <message>
        <source>parameters: %1</source>
        <translation>paramètres : %1</translation>
    </message>
    <message>
        <source>part</source>
        <translation>pièce</translation>
    </message>
    <message>
        <source>part &apos;%1&apos;</source>
        <translation>pièce « %1 »</translation>
    </message>
    <message>
        <source>part &apos;%1&apos; cannot be unpacked</source>
        <translation>la partie « %1 » ne peut être décompressée</translation>
    </message>
    <message>
        <source>part &apos;%1&apos; refers to object &apos;%2&apos; in a circle</source>
        <translation>la partie « %1 » renvoie en cercle à l’objet « %2 »</translation>
    </message>
    <message>
        <source>part &apos;%1&apos; refers to object &apos;%2&apos;, which does not exist</source>
        <translation>la partie « %1 » renvoie à l’objet « %2 », qui n’existe pas</translation>
    </message>
    <message>
        <source>part &apos;%1&apos;, line %2: %3</source>
        <translation>partie « %1 », ligne %2 : %3</translation>
    </message>
    <message>
        <source>part placement</source>
        <translation>placement de la pièce</translation>
    </message>
    <message>
        <source>parts can be read from STEP, IGES, BREP, STL, OBJ, PLY, 3MF and wsurf files</source>
        <translation>les pièces peuvent être lues de fichiers STEP, IGES, BREP, STL, OBJ, PLY, 3MF et wsurf</translation>
    </message>
    <message>
        <source>parts of the layer lie below the substrate and were cut away</source>
        <translation>des parties de la couche sont sous le substrat et ont été coupées</translation>
    </message>
    <message>
        <source>path</source>
        <translation>trajectoire</translation>
    </message>
    <message>
        <source>pick the faces to clad, or raise the part above its plate</source>
        <translation>choisir les faces à recharger, ou lever la pièce au-dessus de sa plaque</translation>
    </message>
    <message>
        <source>pick the faces to clad, or take parallel lines</source>
        <translation>choisir les faces à recharger, ou prendre des lignes parallèles</translation>
    </message>
    <message>
        <source>piece %1</source>
        <translation>morceau %1</translation>
    </message>
    <message>
        <source>piece %1 needs a deposit of %2 mm, outside of %3 to %4 mm</source>
        <translation>le morceau %1 demande un dépôt de %2 mm, hors de %3 à %4 mm</translation>
    </message>
    <message>
        <source>place the part so that it meets the substrate in one closed curve</source>
        <translation>placer la pièce de sorte qu’elle rencontre le substrat en une courbe fermée</translation>
    </message>
    <message>
        <source>place the part so that the joint keeps its direction, or expect a mark</source>
        <translation>placer la pièce de sorte que l’axe garde son sens, ou s’attendre à une marque</translation>
    </message>
    <message>
        <source>placement</source>
        <translation>placement</translation>
    </message>
    <message>
        <source>plan the motion again with this cell</source>
        <translation>planifier de nouveau le mouvement avec cette cellule</translation>
    </message>
    <message>
        <source>planar slicing</source>
        <translation>tranchage plan</translation>
    </message>
    <message>
        <source>plugin</source>
        <translation>extension</translation>
    </message>
    <message>
        <source>plugin %1 (%2) is refused: %3</source>
        <translation>l’extension %1 (%2) est refusée : %3</translation>
    </message>
    <message>
        <source>plugin %1, component %2</source>
        <translation>extension %1, composant %2</translation>
    </message>
    <message>
        <source>positioner %1</source>
        <translation>positionneur %1</translation>
    </message>
    <message>
        <source>post-processing</source>
        <translation>post-traitement</translation>
    </message>
    <message>
        <source>post-processor &apos;%1&apos; cannot be used: %2</source>
        <translation>le post-processeur « %1 » ne peut être utilisé : %2</translation>
    </message>
    <message>
        <source>process</source>
        <translation>procédé</translation>
    </message>
    <message>
        <source>program</source>
        <translation>programme</translation>
    </message>
    <message>
        <source>projection</source>
        <translation>projection</translation>
    </message>
    <message>
        <source>put arc off between the beads</source>
        <translation>éteindre l’arc entre les cordons</translation>
    </message>
    <message>
        <source>put arc on before the bead</source>
        <translation>allumer l’arc avant le cordon</translation>
    </message>
    <message>
        <source>put the bead on the centre or on the other side of the contour, or take a narrower bead</source>
        <translation>mettre le cordon au centre ou de l’autre côté du contour, ou prendre un cordon plus étroit</translation>
    </message>
    <message>
        <source>put the file below the project and write the path from there</source>
        <translation>mettre le fichier sous le projet et écrire le chemin à partir de là</translation>
    </message>
    <message>
        <source>put the file below the project, so that the folder can be moved as a whole</source>
        <translation>mettre le fichier sous le projet, pour que le dossier puisse être déplacé en entier</translation>
    </message>
    <message>
        <source>put the file there or correct its path in the project</source>
        <translation>y mettre le fichier ou corriger son chemin dans le projet</translation>
    </message>
    <message>
        <source>radius and chord error must be positive</source>
        <translation>rayon et erreur de corde doivent être positifs</translation>
    </message>
    <message>
        <source>raise axis_rate, or take an axis rule that turns less</source>
        <translation>augmenter axis_rate, ou prendre une règle d’axe qui tourne moins</translation>
    </message>
    <message>
        <source>raise the part above the substrate</source>
        <translation>lever la pièce au-dessus du substrat</translation>
    </message>
    <message>
        <source>raise the part or lower the substrate</source>
        <translation>lever la pièce ou abaisser le substrat</translation>
    </message>
    <message>
        <source>raise the part, or remove the piece</source>
        <translation>lever la pièce, ou supprimer le morceau</translation>
    </message>
    <message>
        <source>raise tilt_tolerance if the process bears it, or choose another redundancy mode</source>
        <translation>augmenter tilt_tolerance si le procédé le supporte, ou choisir un autre mode de redondance</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>rapport</translation>
    </message>
    <message>
        <source>record longer</source>
        <translation>enregistrer plus longtemps</translation>
    </message>
    <message>
        <source>record the time and the motor speed of every joint of the cell; 0 for those that rest</source>
        <translation>enregistrer le temps et la vitesse de moteur de chaque axe de la cellule ; 0 pour ceux au repos</translation>
    </message>
    <message>
        <source>redo</source>
        <translation>rétablir</translation>
    </message>
    <message>
        <source>refinement</source>
        <translation>raffinement</translation>
    </message>
    <message>
        <source>region</source>
        <translation>région</translation>
    </message>
    <message>
        <source>remove one of them</source>
        <translation>en supprimer un</translation>
    </message>
    <message>
        <source>remove the point</source>
        <translation>supprimer le point</translation>
    </message>
    <message>
        <source>repair or refine the part&apos;s mesh</source>
        <translation>réparer ou raffiner le maillage de la pièce</translation>
    </message>
    <message>
        <source>repair the mesh, or use the propagated distance</source>
        <translation>réparer le maillage, ou utiliser la distance propagée</translation>
    </message>
    <message>
        <source>repair the part</source>
        <translation>réparer la pièce</translation>
    </message>
    <message>
        <source>repair the part if it should be a solid; take a wall strategy if it is a shell</source>
        <translation>réparer la pièce si elle doit être un solide ; prendre une stratégie de paroi si c’est une coque</translation>
    </message>
    <message>
        <source>repair the part&apos;s surface if it should be a solid</source>
        <translation>réparer la surface de la pièce si elle doit être un solide</translation>
    </message>
    <message>
        <source>repair the part&apos;s surface, take a wall strategy, or set open_sections=bead to lay the section itself as a bead</source>
        <translation>réparer la surface de la pièce, prendre une stratégie de paroi, ou régler open_sections=bead pour déposer la section elle-même en cordon</translation>
    </message>
    <message>
        <source>repeat a range of parallel layers</source>
        <translation>répéter une suite de couches parallèles</translation>
    </message>
    <message>
        <source>report this to the vendor of the plugin</source>
        <translation>le signaler au fournisseur de l’extension</translation>
    </message>
    <message>
        <source>report this: a stage before failed</source>
        <translation>le signaler : une étape précédente a échoué</translation>
    </message>
    <message>
        <source>restore the file, or pin the new content with the command file.pin</source>
        <translation>rétablir le fichier, ou épingler le nouveau contenu avec la commande file.pin</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>robot</translation>
    </message>
    <message>
        <source>robot %1</source>
        <translation>robot %1</translation>
    </message>
    <message>
        <source>rotate the torch about its axis by %1</source>
        <translation>tourner la torche autour de son axe de %1</translation>
    </message>
    <message>
        <source>samples are lost there: joint values are uncertain from that time on</source>
        <translation>des échantillons y sont perdus : les valeurs d’axes sont incertaines à partir de ce temps</translation>
    </message>
    <message>
        <source>save the project to keep the new version</source>
        <translation>enregistrer le projet pour garder la nouvelle version</translation>
    </message>
    <message>
        <source>section: &apos;%1&apos; is not one of: %2</source>
        <translation>section : « %1 » n’est pas parmi : %2</translation>
    </message>
    <message>
        <source>sections</source>
        <translation>sections</translation>
    </message>
    <message>
        <source>see the list of commands</source>
        <translation>voir la liste des commandes</translation>
    </message>
    <message>
        <source>see the page on part formats</source>
        <translation>voir la page sur les formats de pièces</translation>
    </message>
    <message>
        <source>separate lines by &apos;|&apos;</source>
        <translation>séparer les lignes par « | »</translation>
    </message>
    <message>
        <source>separate the bodies that touch along an edge</source>
        <translation>séparer les corps qui se touchent le long d’une arête</translation>
    </message>
    <message>
        <source>separate the columns as in the header and write decimal points</source>
        <translation>séparer les colonnes comme dans l’en-tête et écrire des points décimaux</translation>
    </message>
    <message>
        <source>set &quot;branch&quot; to auto</source>
        <translation>mettre « branch » à auto</translation>
    </message>
    <message>
        <source>set &quot;cell&quot; to a cell file</source>
        <translation>mettre un fichier de cellule dans « cell »</translation>
    </message>
    <message>
        <source>set close_gap, or delete the layers above as well</source>
        <translation>régler close_gap, ou supprimer aussi les couches du dessus</translation>
    </message>
    <message>
        <source>set it between 0 and 1</source>
        <translation>le régler entre 0 et 1</translation>
    </message>
    <message>
        <source>set it to 0 or more</source>
        <translation>le régler à 0 ou plus</translation>
    </message>
    <message>
        <source>set mode=joint</source>
        <translation>régler mode=joint</translation>
    </message>
    <message>
        <source>set the operation&apos;s &quot;file&quot; to a table of points</source>
        <translation>mettre une table de points dans « file » de l’opération</translation>
    </message>
    <message>
        <source>set the option &apos;unit&apos; if this is wrong</source>
        <translation>régler l’option « unit » si c’est faux</translation>
    </message>
    <message>
        <source>set the travel speeds of the operation</source>
        <translation>régler les vitesses d’avance de l’opération</translation>
    </message>
    <message>
        <source>set the wire speed of the process</source>
        <translation>régler la vitesse de fil du procédé</translation>
    </message>
    <message>
        <source>sharp edges of a mesh can do this: use a finer mesh edge length or the CAD file</source>
        <translation>des arêtes vives d’un maillage peuvent en être cause : utiliser une longueur d’arête plus fine ou le fichier CAO</translation>
    </message>
    <message>
        <source>shoulder singularity: the wrist centre is %1 mm from axis 1 at %2</source>
        <translation>singularité de l’épaule : le centre du poignet est à %1 mm de l’axe 1 en %2</translation>
    </message>
    <message>
        <source>singularity: a joint moves the tool as the others do but for %1 at %2</source>
        <translation>singularité : un axe déplace l’outil comme les autres à %1 près en %2</translation>
    </message>
    <message>
        <source>singularity: the tool is in line with axis %3 but for %1 at %2</source>
        <translation>singularité : l’outil est aligné avec l’axe %3 à %1 près en %2</translation>
    </message>
    <message>
        <source>skeleton</source>
        <translation>squelette</translation>
    </message>
    <message>
        <source>slice</source>
        <translation>tranchage</translation>
    </message>
    <message>
        <source>slice this piece by isovalues</source>
        <translation>trancher ce morceau par iso-valeurs</translation>
    </message>
    <message>
        <source>slicing</source>
        <translation>tranchage</translation>
    </message>
    <message>
        <source>slicing around an axis</source>
        <translation>tranchage autour d’un axe</translation>
    </message>
    <message>
        <source>slicing normal to a guide</source>
        <translation>tranchage normal à un guide</translation>
    </message>
    <message>
        <source>slicing of branching parts</source>
        <translation>tranchage de pièces à branches</translation>
    </message>
    <message>
        <source>slicing of branching parts, pieces</source>
        <translation>tranchage de pièces à branches, morceaux</translation>
    </message>
    <message>
        <source>smooth the path, allow more rounding of corners, lower the travel speed, or let the wire feed follow (wire_follows_speed)</source>
        <translation>lisser la trajectoire, permettre plus d’arrondi des coins, baisser la vitesse d’avance, ou laisser suivre la vitesse de fil (wire_follows_speed)</translation>
    </message>
    <message>
        <source>sort the rows by time and remove repeated ones</source>
        <translation>trier les lignes par temps et supprimer les répétées</translation>
    </message>
    <message>
        <source>spacing, angle or phase is no usable number</source>
        <translation>espacement, angle ou phase n’est pas un nombre utilisable</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>vitesse</translation>
    </message>
    <message>
        <source>spiral</source>
        <translation>spirale</translation>
    </message>
    <message>
        <source>split the part where they meet, or choose the working surface with one lower border</source>
        <translation>couper la pièce où ils se rencontrent, ou choisir la surface de travail avec un seul bord inférieur</translation>
    </message>
    <message>
        <source>split the range where the formula has a corner or a vertical tangent</source>
        <translation>couper le domaine où la formule a un coin ou une tangente verticale</translation>
    </message>
    <message>
        <source>stands beside &apos;faces&apos;: name the faces or the side of the wall</source>
        <translation>est à côté de « faces » : nommer les faces ou le côté de la paroi</translation>
    </message>
    <message>
        <source>stands twice in one object</source>
        <translation>apparaît deux fois dans un objet</translation>
    </message>
    <message>
        <source>stands twice in the list</source>
        <translation>apparaît deux fois dans la liste</translation>
    </message>
    <message>
        <source>status &apos;%1&apos; is not three binary digits</source>
        <translation>l’état « %1 » n’est pas fait de trois chiffres binaires</translation>
    </message>
    <message>
        <source>step</source>
        <translation>pas</translation>
    </message>
    <message>
        <source>step and conduction must be positive, the geodesic share between 0 and 1</source>
        <translation>pas et conduction doivent être positifs, la part géodésique entre 0 et 1</translation>
    </message>
    <message>
        <source>stopped as if it were cancelled, but nobody asked for it</source>
        <translation>s’est arrêté comme s’il était annulé, mais personne ne l’a demandé</translation>
    </message>
    <message>
        <source>strategy &apos;%1&apos; cannot be used: %2</source>
        <translation>la stratégie « %1 » ne peut être utilisée : %2</translation>
    </message>
    <message>
        <source>stroke</source>
        <translation>trait</translation>
    </message>
    <message>
        <source>stroke %1, point %2</source>
        <translation>trait %1, point %2</translation>
    </message>
    <message>
        <source>substrate</source>
        <translation>substrat</translation>
    </message>
    <message>
        <source>surface refinement</source>
        <translation>raffinement de surface</translation>
    </message>
    <message>
        <source>take a smaller angle, or replace the planned one instead of adding to it</source>
        <translation>prendre un angle plus petit, ou remplacer celui prévu au lieu de s’y ajouter</translation>
    </message>
    <message>
        <source>take the whole surface, or pick the faces of the working surface</source>
        <translation>prendre toute la surface, ou choisir les faces de la surface de travail</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>température</translation>
    </message>
    <message>
        <source>the %1 file has no shape that can be read%2</source>
        <translation>le fichier %1 n’a pas de forme lisible%2</translation>
    </message>
    <message>
        <source>the CAD file asks for more memory than it can need</source>
        <translation>le fichier CAO demande plus de mémoire qu’il ne peut en falloir</translation>
    </message>
    <message>
        <source>the CAD library broke down on this file</source>
        <translation>la bibliothèque CAO s’est effondrée sur ce fichier</translation>
    </message>
    <message>
        <source>the CAD library broke down on this file (signal %1)</source>
        <translation>la bibliothèque CAO s’est effondrée sur ce fichier (signal %1)</translation>
    </message>
    <message>
        <source>the CAD library does not come to an end with this file</source>
        <translation>la bibliothèque CAO ne vient pas à bout de ce fichier</translation>
    </message>
    <message>
        <source>the CAD library fails on this file: %1</source>
        <translation>la bibliothèque CAO échoue sur ce fichier : %1</translation>
    </message>
    <message>
        <source>the CAD reader reports%1</source>
        <translation>le lecteur CAO signale%1</translation>
    </message>
    <message>
        <source>the CAD worker cannot be started: %1</source>
        <translation>le processus CAO ne peut être lancé : %1</translation>
    </message>
    <message>
        <source>the answer of the CAD worker is damaged</source>
        <translation>la réponse du processus CAO est endommagée</translation>
    </message>
    <message>
        <source>the arc goes off while it is off</source>
        <translation>l’arc est éteint alors qu’il l’est déjà</translation>
    </message>
    <message>
        <source>the arc goes on before the first move</source>
        <translation>l’arc est allumé avant le premier mouvement</translation>
    </message>
    <message>
        <source>the arc goes on while it is on</source>
        <translation>l’arc est allumé alors qu’il l’est déjà</translation>
    </message>
    <message>
        <source>the arc is still on at the end</source>
        <translation>l’arc est encore allumé à la fin</translation>
    </message>
    <message>
        <source>the arguments must be an object, got %1</source>
        <translation>les arguments doivent être un objet, reçu : %1</translation>
    </message>
    <message>
        <source>the axes are left-handed</source>
        <translation>les axes sont indirects</translation>
    </message>
    <message>
        <source>the axes are not perpendicular unit vectors (off by %1)</source>
        <translation>les axes ne sont pas des vecteurs unitaires perpendiculaires (écart de %1)</translation>
    </message>
    <message>
        <source>the axis has no direction</source>
        <translation>l’axe n’a pas de direction</translation>
    </message>
    <message>
        <source>the axis&apos; half planes do not meet the part</source>
        <translation>les demi-plans de l’axe ne rencontrent pas la pièce</translation>
    </message>
    <message>
        <source>the bead width is not above 0</source>
        <translation>la largeur de cordon n’est pas supérieure à 0</translation>
    </message>
    <message>
        <source>the bead width of %1 mm is outside its range of %2 to %3 mm</source>
        <translation>la largeur de cordon de %1 mm est hors de son domaine de %2 à %3 mm</translation>
    </message>
    <message>
        <source>the borders of the wall must lie apart: check the working surface</source>
        <translation>les bords de la paroi doivent être séparés : vérifier la surface de travail</translation>
    </message>
    <message>
        <source>the build direction has no length</source>
        <translation>la direction de construction n’a pas de longueur</translation>
    </message>
    <message>
        <source>the build direction is up to %1 off the vertical at %2</source>
        <translation>la direction de construction s’écarte de la verticale de jusqu’à %1 en %2</translation>
    </message>
    <message>
        <source>the cell file declares none</source>
        <translation>le fichier de cellule n’en déclare aucune</translation>
    </message>
    <message>
        <source>the cell file declares: %1</source>
        <translation>le fichier de cellule déclare : %1</translation>
    </message>
    <message>
        <source>the cell file has format version %1; this program reads versions up to %2</source>
        <translation>le fichier de cellule a la version de format %1 ; ce programme lit les versions jusqu’à %2</translation>
    </message>
    <message>
        <source>the cell has no frame &apos;%1&apos;</source>
        <translation>la cellule n’a pas de repère « %1 »</translation>
    </message>
    <message>
        <source>the cell has no frame &apos;%1&apos;; it has %2</source>
        <translation>la cellule n’a pas de repère « %1 » ; elle a %2</translation>
    </message>
    <message>
        <source>the cell&apos;s other_configuration %1 does not exist</source>
        <translation>le fichier other_configuration %1 de la cellule n’existe pas</translation>
    </message>
    <message>
        <source>the centre distance must be above 0 and at most 1 bead width</source>
        <translation>l’entraxe doit être supérieur à 0 et d’au plus 1 largeur de cordon</translation>
    </message>
    <message>
        <source>the closed-form inverse kinematics needs 6 revolute joints</source>
        <translation>la cinématique inverse analytique demande 6 axes rotatifs</translation>
    </message>
    <message>
        <source>the closed-form inverse kinematics needs axes 2 and 3 parallel, both at a right angle to axes 1 and 4, and axes 4, 5, 6 meeting at right angles in one point</source>
        <translation>la cinématique inverse analytique demande des axes 2 et 3 parallèles, tous deux à angle droit des axes 1 et 4, et des axes 4, 5, 6 à angle droit et concourants</translation>
    </message>
    <message>
        <source>the closed-form inverse kinematics of an arm needs 6 revolute joints</source>
        <translation>la cinématique inverse analytique d’un bras demande 6 axes rotatifs</translation>
    </message>
    <message>
        <source>the column %1 is missing</source>
        <translation>la colonne %1 manque</translation>
    </message>
    <message>
        <source>the column %1 stands twice in the header</source>
        <translation>la colonne %1 est deux fois dans l’en-tête</translation>
    </message>
    <message>
        <source>the column &apos;%1&apos; is not in mm</source>
        <translation>la colonne « %1 » n’est pas en mm</translation>
    </message>
    <message>
        <source>the column &apos;%1&apos; is not known</source>
        <translation>la colonne « %1 » n’est pas connue</translation>
    </message>
    <message>
        <source>the column &apos;%1&apos; is not known; did you mean &apos;%2&apos;?</source>
        <translation>la colonne « %1 » n’est pas connue ; vouliez-vous dire « %2 » ?</translation>
    </message>
    <message>
        <source>the column &apos;%1&apos; stands twice</source>
        <translation>la colonne « %1 » apparaît deux fois</translation>
    </message>
    <message>
        <source>the columns %1 are missing</source>
        <translation>les colonnes %1 manquent</translation>
    </message>
    <message>
        <source>the condition &apos;%1&apos; names no declared parameter</source>
        <translation>la condition « %1 » ne nomme aucun paramètre déclaré</translation>
    </message>
    <message>
        <source>the conductivity of triangle %1 is not positive</source>
        <translation>la conductivité du triangle %1 n’est pas positive</translation>
    </message>
    <message>
        <source>the curve at %1 % of the part&apos;s height is not closed</source>
        <translation>la courbe à %1 % de la hauteur de la pièce n’est pas fermée</translation>
    </message>
    <message>
        <source>the description %1</source>
        <translation>la description %1</translation>
    </message>
    <message>
        <source>the dexterity falls to %1 at %2</source>
        <translation>la dextérité tombe à %1 en %2</translation>
    </message>
    <message>
        <source>the direction across the beads has no length</source>
        <translation>la direction en travers des cordons n’a pas de longueur</translation>
    </message>
    <message>
        <source>the distance from the border vanishes everywhere</source>
        <translation>la distance au bord est nulle partout</translation>
    </message>
    <message>
        <source>the distance has no source</source>
        <translation>la distance n’a pas de source</translation>
    </message>
    <message>
        <source>the edit &apos;%1&apos; (%2)</source>
        <translation>la retouche « %1 » (%2)</translation>
    </message>
    <message>
        <source>the edit &apos;%1&apos; has no parameter &apos;%2&apos;</source>
        <translation>la retouche « %1 » n’a pas de paramètre « %2 »</translation>
    </message>
    <message>
        <source>the edits leave no layer to build</source>
        <translation>les retouches ne laissent aucune couche à construire</translation>
    </message>
    <message>
        <source>the envelope does not reach the surface at (%1, %2, %3), %4 mm beside it: there is an overhang</source>
        <translation>l’enveloppe n’atteint pas la surface en (%1, %2, %3), à %4 mm d’elle : il y a un surplomb</translation>
    </message>
    <message>
        <source>the envelope&apos;s line at %1° does not meet the part</source>
        <translation>la ligne de l’enveloppe à %1° ne rencontre pas la pièce</translation>
    </message>
    <message>
        <source>the face refers to vertex %1; there are %2 before it</source>
        <translation>la face renvoie au sommet %1 ; il y en a %2 avant elle</translation>
    </message>
    <message>
        <source>the factory of component &apos;%1&apos; failed: %2</source>
        <translation>la fabrique du composant « %1 » a échoué : %2</translation>
    </message>
    <message>
        <source>the factory of component &apos;%1&apos; returned nothing</source>
        <translation>la fabrique du composant « %1 » n’a rien rendu</translation>
    </message>
    <message>
        <source>the field has no gradient on a piece of the part</source>
        <translation>le champ n’a pas de gradient sur un morceau de la pièce</translation>
    </message>
    <message>
        <source>the field has values for another number of parts</source>
        <translation>le champ a des valeurs pour un autre nombre de pièces</translation>
    </message>
    <message>
        <source>the field has values for another number of vertices</source>
        <translation>le champ a des valeurs pour un autre nombre de sommets</translation>
    </message>
    <message>
        <source>the field must have one value per vertex</source>
        <translation>le champ doit avoir une valeur par sommet</translation>
    </message>
    <message>
        <source>the field must have one value per vertex and the least branch must not be negative</source>
        <translation>le champ doit avoir une valeur par sommet et la branche minimale ne doit pas être négative</translation>
    </message>
    <message>
        <source>the file became shorter while it was read</source>
        <translation>le fichier a raccourci pendant la lecture</translation>
    </message>
    <message>
        <source>the file does not exist</source>
        <translation>le fichier n’existe pas</translation>
    </message>
    <message>
        <source>the file does not keep the rules of its own version</source>
        <translation>le fichier ne respecte pas les règles de sa propre version</translation>
    </message>
    <message>
        <source>the file ends in %1</source>
        <translation>le fichier finit dans %1</translation>
    </message>
    <message>
        <source>the file ends inside facet %1</source>
        <translation>le fichier finit dans la facette %1</translation>
    </message>
    <message>
        <source>the file ends without its last line and may be cut off</source>
        <translation>le fichier finit sans sa dernière ligne et peut être tronqué</translation>
    </message>
    <message>
        <source>the file has no surface; it has %1%2</source>
        <translation>le fichier n’a pas de surface ; il a %1%2</translation>
    </message>
    <message>
        <source>the file has no triangles</source>
        <translation>le fichier n’a pas de triangles</translation>
    </message>
    <message>
        <source>the file has surfaces but no solid</source>
        <translation>le fichier a des surfaces mais pas de solide</translation>
    </message>
    <message>
        <source>the file holds no object, so it is no WCAM project</source>
        <translation>le fichier ne contient pas d’objet, ce n’est donc pas un projet WCAM</translation>
    </message>
    <message>
        <source>the file holds no process parameters</source>
        <translation>le fichier ne contient pas de paramètres de procédé</translation>
    </message>
    <message>
        <source>the file is cut off or is not an STL file; export it again</source>
        <translation>le fichier est tronqué ou n’est pas un fichier STL ; l’exporter de nouveau</translation>
    </message>
    <message>
        <source>the file is damaged or cut off; export it again</source>
        <translation>le fichier est endommagé ou tronqué ; l’exporter de nouveau</translation>
    </message>
    <message>
        <source>the file is damaged or has the wrong extension</source>
        <translation>le fichier est endommagé ou a la mauvaise extension</translation>
    </message>
    <message>
        <source>the file is damaged or is not an OBJ file; export it again</source>
        <translation>le fichier est endommagé ou n’est pas un fichier OBJ ; l’exporter de nouveau</translation>
    </message>
    <message>
        <source>the file is damaged, or the chord tolerance is too small for it</source>
        <translation>le fichier est endommagé, ou la tolérance de corde est trop petite pour lui</translation>
    </message>
    <message>
        <source>the file is damaged; export the part again</source>
        <translation>le fichier est endommagé ; exporter la pièce de nouveau</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>le fichier est vide</translation>
    </message>
    <message>
        <source>the file must be UTF-8 JSON</source>
        <translation>le fichier doit être du JSON en UTF-8</translation>
    </message>
    <message>
        <source>the first move is not a joint move</source>
        <translation>le premier mouvement n’est pas un mouvement d’axes</translation>
    </message>
    <message>
        <source>the folder cannot be made: %1</source>
        <translation>le dossier ne peut être créé : %1</translation>
    </message>
    <message>
        <source>the folder cannot be made: a file has this name</source>
        <translation>le dossier ne peut être créé : un fichier porte ce nom</translation>
    </message>
    <message>
        <source>the folder cannot be read: %1</source>
        <translation>le dossier ne peut être lu : %1</translation>
    </message>
    <message>
        <source>the folder cannot be written to: %1</source>
        <translation>le dossier ne peut être écrit : %1</translation>
    </message>
    <message>
        <source>the format of the file is not known</source>
        <translation>le format du fichier n’est pas connu</translation>
    </message>
    <message>
        <source>the formula has no finite value at %1</source>
        <translation>la formule n’a pas de valeur finie en %1</translation>
    </message>
    <message>
        <source>the generatrix from (%1, %2, %3), %4 mm long, needs a deposit of %5 mm, %6 mm outside of %7 to %8 mm</source>
        <translation>la génératrice de (%1, %2, %3), longue de %4 mm, demande un dépôt de %5 mm, %6 mm hors de %7 à %8 mm</translation>
    </message>
    <message>
        <source>the greatest edge length must be positive</source>
        <translation>la longueur d’arête maximale doit être positive</translation>
    </message>
    <message>
        <source>the guide &apos;%1&apos; does not move with the part</source>
        <translation>le guide « %1 » ne bouge pas avec la pièce</translation>
    </message>
    <message>
        <source>the guide curve stands still at parameter %1</source>
        <translation>la courbe guide s’arrête au paramètre %1</translation>
    </message>
    <message>
        <source>the guide is shorter than the first layer</source>
        <translation>le guide est plus court que la première couche</translation>
    </message>
    <message>
        <source>the guide is straight at t = %1 and has no Frenet frame</source>
        <translation>le guide est droit à t = %1 et n’a pas de repère de Frenet</translation>
    </message>
    <message>
        <source>the header does not tell the format</source>
        <translation>l’en-tête n’indique pas le format</translation>
    </message>
    <message>
        <source>the header has no column %1</source>
        <translation>l’en-tête n’a pas de colonne %1</translation>
    </message>
    <message>
        <source>the header has no end</source>
        <translation>l’en-tête n’a pas de fin</translation>
    </message>
    <message>
        <source>the header names the columns: layer,bead,x_mm,y_mm,z_mm and more</source>
        <translation>l’en-tête nomme les colonnes : layer,bead,x_mm,y_mm,z_mm et d’autres</translation>
    </message>
    <message>
        <source>the header tells %1 of element &apos;%2&apos;, the file has only %3 bytes</source>
        <translation>l’en-tête annonce %1 de l’élément « %2 », le fichier n’a que %3 octets</translation>
    </message>
    <message>
        <source>the header tells %1 triangles (%2 bytes), the file has only %3 bytes</source>
        <translation>l’en-tête annonce %1 triangles (%2 octets), le fichier n’a que %3 octets</translation>
    </message>
    <message>
        <source>the joint name &apos;%1&apos; is used twice</source>
        <translation>le nom d’axe « %1 » sert deux fois</translation>
    </message>
    <message>
        <source>the key &apos;%1&apos; is missing</source>
        <translation>la clé « %1 » manque</translation>
    </message>
    <message>
        <source>the key &apos;%1&apos; is missing; the type %2 needs it</source>
        <translation>la clé « %1 » manque ; le type %2 en a besoin</translation>
    </message>
    <message>
        <source>the key &apos;%1&apos; stands twice in one object</source>
        <translation>la clé « %1 » est deux fois dans un objet</translation>
    </message>
    <message>
        <source>the key &apos;id&apos; is missing</source>
        <translation>la clé « id » manque</translation>
    </message>
    <message>
        <source>the layer at %1 meets no part</source>
        <translation>la couche à %1 ne rencontre aucune pièce</translation>
    </message>
    <message>
        <source>the layer at %1 mm lies up to %2 mm from the layer below, although the planes are as near as the process allows</source>
        <translation>la couche à %1 mm est à jusqu’à %2 mm de la couche inférieure, bien que les plans soient aussi proches que le procédé le permet</translation>
    </message>
    <message>
        <source>the layers meet the part in points only</source>
        <translation>les couches ne rencontrent la pièce qu’en des points</translation>
    </message>
    <message>
        <source>the least bead width is above the greatest one</source>
        <translation>la largeur de cordon minimale est au-dessus de la maximale</translation>
    </message>
    <message>
        <source>the library says id &apos;%1&apos;, the manifest &apos;%2&apos;</source>
        <translation>la bibliothèque dit l’identifiant « %1 », le manifeste « %2 »</translation>
    </message>
    <message>
        <source>the library says version &apos;%1&apos;, the manifest &apos;%2&apos;</source>
        <translation>la bibliothèque dit la version « %1 », le manifeste « %2 »</translation>
    </message>
    <message>
        <source>the limit of mitres must be above 1</source>
        <translation>la limite des onglets doit être supérieure à 1</translation>
    </message>
    <message>
        <source>the line has %1 cells, the header %2</source>
        <translation>la ligne a %1 cellules, l’en-tête %2</translation>
    </message>
    <message>
        <source>the lower border is not a closed curve</source>
        <translation>le bord inférieur n’est pas une courbe fermée</translation>
    </message>
    <message>
        <source>the lowest border of the part does not lie on the substrate: it is %1 to %2 mm above it, most at %3</source>
        <translation>le bord le plus bas de la pièce n’est pas sur le substrat : il est de %1 à %2 mm au-dessus, le plus en %3</translation>
    </message>
    <message>
        <source>the manifest must be a JSON object; wcam_add_plugin() writes it</source>
        <translation>le manifeste doit être un objet JSON ; wcam_add_plugin() l’écrit</translation>
    </message>
    <message>
        <source>the mean deposit of %1 mm lies outside the range of %2 to %3 mm</source>
        <translation>le dépôt moyen de %1 mm est hors du domaine de %2 à %3 mm</translation>
    </message>
    <message>
        <source>the mesh &apos;%1&apos; has no triangles</source>
        <translation>le maillage « %1 » n’a pas de triangles</translation>
    </message>
    <message>
        <source>the mesh is too degenerate to solve for a distance</source>
        <translation>le maillage est trop dégénéré pour calculer une distance</translation>
    </message>
    <message>
        <source>the mesh is too degenerate to solve for a field</source>
        <translation>le maillage est trop dégénéré pour calculer un champ</translation>
    </message>
    <message>
        <source>the minimum must be below the maximum</source>
        <translation>le minimum doit être inférieur au maximum</translation>
    </message>
    <message>
        <source>the mode %1 turns the last axis of the positioner, and the cell has none</source>
        <translation>le mode %1 tourne le dernier axe du positionneur, et la cellule n’en a pas</translation>
    </message>
    <message>
        <source>the mode %1 turns the last axis of the positioner, and the cell has none: the robot carries the part</source>
        <translation>le mode %1 tourne le dernier axe du positionneur, et la cellule n’en a pas : le robot porte la pièce</translation>
    </message>
    <message>
        <source>the modulation range is a single height</source>
        <translation>le domaine de modulation est une seule hauteur</translation>
    </message>
    <message>
        <source>the modulation range must lie above zero</source>
        <translation>le domaine de modulation doit être au-dessus de zéro</translation>
    </message>
    <message>
        <source>the normal of the cutting plane has no length</source>
        <translation>la normale du plan de coupe n’a pas de longueur</translation>
    </message>
    <message>
        <source>the number of walls is negative</source>
        <translation>le nombre de parois est négatif</translation>
    </message>
    <message>
        <source>the offset is no finite number</source>
        <translation>le décalage n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>the oldest version is %1</source>
        <translation>la version la plus ancienne est %1</translation>
    </message>
    <message>
        <source>the operation names no file with a path</source>
        <translation>l’opération ne nomme pas de fichier avec une trajectoire</translation>
    </message>
    <message>
        <source>the operation names no guide curve</source>
        <translation>l’opération ne nomme pas de courbe guide</translation>
    </message>
    <message>
        <source>the output &apos;%1&apos; for &apos;%2&apos;</source>
        <translation>la sortie « %1 » pour « %2 »</translation>
    </message>
    <message>
        <source>the package has no part &apos;%1&apos;</source>
        <translation>l’archive n’a pas de partie « %1 »</translation>
    </message>
    <message>
        <source>the package has nothing to build</source>
        <translation>l’archive n’a rien à construire</translation>
    </message>
    <message>
        <source>the package repeats its objects more than %1 times</source>
        <translation>l’archive répète ses objets plus de %1 fois</translation>
    </message>
    <message>
        <source>the part &apos;%1&apos; is a mesh and has no CAD edges</source>
        <translation>la pièce « %1 » est un maillage et n’a pas d’arêtes CAO</translation>
    </message>
    <message>
        <source>the part (layer %1, bead %2, point %3)</source>
        <translation>la pièce (couche %1, cordon %2, point %3)</translation>
    </message>
    <message>
        <source>the part branches: at %1 % of its height there are %2 curves, one of them at (%3, %4, %5)</source>
        <translation>la pièce se ramifie : à %1 % de sa hauteur il y a %2 courbes, dont une en (%3, %4, %5)</translation>
    </message>
    <message>
        <source>the part branches: its axis has %1 pieces</source>
        <translation>la pièce se ramifie : son axe a %1 morceaux</translation>
    </message>
    <message>
        <source>the part consists of %1 separate pieces</source>
        <translation>la pièce est faite de %1 morceaux séparés</translation>
    </message>
    <message>
        <source>the part does not touch the substrate along a curve; its lowest point is %1 mm above it</source>
        <translation>la pièce ne touche pas le substrat le long d’une courbe ; son point le plus bas est %1 mm au-dessus</translation>
    </message>
    <message>
        <source>the part ends less than one step above its base: choose a smaller step</source>
        <translation>la pièce finit à moins d’un pas de sa base : choisir un pas plus petit</translation>
    </message>
    <message>
        <source>the part has %1 lower borders, near %2</source>
        <translation>la pièce a %1 bords inférieurs, près de %2</translation>
    </message>
    <message>
        <source>the part has %1 piece</source>
        <translation>la pièce a %1 morceau</translation>
    </message>
    <message>
        <source>the part has %1 piece, cut at %2 mm of the field</source>
        <translation>la pièce a %1 morceau, coupé à %2 mm du champ</translation>
    </message>
    <message>
        <source>the part has %1 pieces</source>
        <translation>la pièce a %1 morceaux</translation>
    </message>
    <message>
        <source>the part has %1 pieces, cut at %2 mm of the field</source>
        <translation>la pièce a %1 morceaux, coupés à %2 mm du champ</translation>
    </message>
    <message>
        <source>the part has %1 upper borders, one near %2</source>
        <translation>la pièce a %1 bords supérieurs, dont un près de %2</translation>
    </message>
    <message>
        <source>the part has more than one lower border</source>
        <translation>la pièce a plus d’un bord inférieur</translation>
    </message>
    <message>
        <source>the part has no edge named &apos;%1&apos;</source>
        <translation>la pièce n’a pas d’arête nommée « %1 »</translation>
    </message>
    <message>
        <source>the part has no lower border</source>
        <translation>la pièce n’a pas de bord inférieur</translation>
    </message>
    <message>
        <source>the part has no lower border to start from</source>
        <translation>la pièce n’a pas de bord inférieur d’où partir</translation>
    </message>
    <message>
        <source>the part has no piece %1: its pieces are 0 to %2</source>
        <translation>la pièce n’a pas de morceau %1 : ses morceaux sont 0 à %2</translation>
    </message>
    <message>
        <source>the part has no triangles</source>
        <translation>la pièce n’a pas de triangles</translation>
    </message>
    <message>
        <source>the part has only degenerate triangles</source>
        <translation>la pièce n’a que des triangles dégénérés</translation>
    </message>
    <message>
        <source>the part is a closed surface without a border</source>
        <translation>la pièce est une surface fermée sans bord</translation>
    </message>
    <message>
        <source>the part is a mesh and has no CAD edges</source>
        <translation>la pièce est un maillage et n’a pas d’arêtes CAO</translation>
    </message>
    <message>
        <source>the part is a mesh: it has no parameters to follow</source>
        <translation>la pièce est un maillage : elle n’a pas de paramètres à suivre</translation>
    </message>
    <message>
        <source>the part is an open surface, no solid wall: it is its own working surface</source>
        <translation>la pièce est une surface ouverte, pas une paroi épaisse : elle est sa propre surface de travail</translation>
    </message>
    <message>
        <source>the part is lower than one layer</source>
        <translation>la pièce est plus basse qu’une couche</translation>
    </message>
    <message>
        <source>the part is no body of revolution: its normals meet no common axis</source>
        <translation>la pièce n’est pas un corps de révolution : ses normales ne rencontrent pas d’axe commun</translation>
    </message>
    <message>
        <source>the part is no body of revolution: the point (%1, %2, %3) is %4 mm off the profile</source>
        <translation>la pièce n’est pas un corps de révolution : le point (%1, %2, %3) est à %4 mm du profil</translation>
    </message>
    <message>
        <source>the part is no solid wall: it has only one side</source>
        <translation>la pièce n’est pas une paroi épaisse : elle n’a qu’un côté</translation>
    </message>
    <message>
        <source>the part is no solid wall: its two sides are not parted by rims (a bulk part, or one as thick as high)</source>
        <translation>la pièce n’est pas une paroi épaisse : ses deux côtés ne sont pas séparés par des rebords (une pièce massive, ou aussi épaisse que haute)</translation>
    </message>
    <message>
        <source>the part is no solid wall: nowhere do two sides of it look at each other</source>
        <translation>la pièce n’est pas une paroi épaisse : nulle part deux de ses côtés ne se font face</translation>
    </message>
    <message>
        <source>the part is smaller than one layer: its farthest point is %1 mm from the base, the first layer at %2 mm</source>
        <translation>la pièce est plus petite qu’une couche : son point le plus éloigné est à %1 mm de la base, la première couche à %2 mm</translation>
    </message>
    <message>
        <source>the part is too short for an axis</source>
        <translation>la pièce est trop courte pour un axe</translation>
    </message>
    <message>
        <source>the part is wider than the guide&apos;s radius of curvature there: use a straighter guide or another strategy</source>
        <translation>la pièce y est plus large que le rayon de courbure du guide : utiliser un guide plus droit ou une autre stratégie</translation>
    </message>
    <message>
        <source>the part lies on the axis</source>
        <translation>la pièce est sur l’axe</translation>
    </message>
    <message>
        <source>the part must be one connected surface: repair it</source>
        <translation>la pièce doit être une surface d’un seul tenant : la réparer</translation>
    </message>
    <message>
        <source>the part needs a process whose greatest height is %1 times the least one; %2</source>
        <translation>la pièce demande un procédé dont la plus grande hauteur est %1 fois la plus petite ; %2</translation>
    </message>
    <message>
        <source>the part passes through the substrate, and heat starts at borders only</source>
        <translation>la pièce traverse le substrat, et la chaleur ne part que des bords</translation>
    </message>
    <message>
        <source>the part stands on %1 borders; layers grow from all of them and meet</source>
        <translation>la pièce repose sur %1 bords ; les couches croissent depuis tous et se rencontrent</translation>
    </message>
    <message>
        <source>the path of a file must not be empty</source>
        <translation>le chemin d’un fichier ne doit pas être vide</translation>
    </message>
    <message>
        <source>the placement is not a rotation and a translation</source>
        <translation>le placement n’est pas une rotation et une translation</translation>
    </message>
    <message>
        <source>the plate needs a positive length, width and thickness</source>
        <translation>la plaque demande une longueur, une largeur et une épaisseur positives</translation>
    </message>
    <message>
        <source>the positioner&apos;s axes cannot turn it further; choose another build direction</source>
        <translation>les axes du positionneur ne peuvent la tourner plus ; choisir une autre direction de construction</translation>
    </message>
    <message>
        <source>the process&apos;s layer heights do not ascend</source>
        <translation>les hauteurs de couche du procédé ne sont pas croissantes</translation>
    </message>
    <message>
        <source>the profile cannot be revolved</source>
        <translation>le profil ne peut être tourné autour de l’axe</translation>
    </message>
    <message>
        <source>the program cannot be printed:
  %1</source>
        <translation>le programme ne peut être écrit :
  %1</translation>
    </message>
    <message>
        <source>the program has no move</source>
        <translation>le programme n’a pas de mouvement</translation>
    </message>
    <message>
        <source>the project has no enabled operation</source>
        <translation>le projet n’a pas d’opération active</translation>
    </message>
    <message>
        <source>the project has no operation &apos;%1&apos;</source>
        <translation>le projet n’a pas d’opération « %1 »</translation>
    </message>
    <message>
        <source>the project names no cell</source>
        <translation>le projet ne nomme pas de cellule</translation>
    </message>
    <message>
        <source>the project was written by a newer version (format %1, this program knows %2): it can be looked at, not changed</source>
        <translation>le projet a été écrit par une version plus récente (format %1, ce programme connaît %2) : il peut être regardé, pas modifié</translation>
    </message>
    <message>
        <source>the project was written by a newer version and cannot be changed by this one</source>
        <translation>le projet a été écrit par une version plus récente et ne peut être modifié par celle-ci</translation>
    </message>
    <message>
        <source>the project was written by a newer version and cannot be saved by this one</source>
        <translation>le projet a été écrit par une version plus récente et ne peut être enregistré par celle-ci</translation>
    </message>
    <message>
        <source>the project was written by a newer version, and this one understands it only in part: no robot program is made from it</source>
        <translation>le projet a été écrit par une version plus récente, et celle-ci ne le comprend qu’en partie : aucun programme de robot n’en est fait</translation>
    </message>
    <message>
        <source>the radius is %1 at t = %2</source>
        <translation>le rayon est %1 à t = %2</translation>
    </message>
    <message>
        <source>the radius is %1 at z = %2</source>
        <translation>le rayon est %1 à z = %2</translation>
    </message>
    <message>
        <source>the radius must be positive along the whole guide</source>
        <translation>le rayon doit être positif tout le long du guide</translation>
    </message>
    <message>
        <source>the radius must not be negative</source>
        <translation>le rayon ne doit pas être négatif</translation>
    </message>
    <message>
        <source>the range ends before it begins; exchange first_layer and last_layer</source>
        <translation>la suite finit avant de commencer ; échanger first_layer et last_layer</translation>
    </message>
    <message>
        <source>the range must ascend</source>
        <translation>le domaine doit être croissant</translation>
    </message>
    <message>
        <source>the recording has fewer than 2 rows</source>
        <translation>l’enregistrement a moins de 2 lignes</translation>
    </message>
    <message>
        <source>the recording is empty</source>
        <translation>l’enregistrement est vide</translation>
    </message>
    <message>
        <source>the reduction ratio is unknown of %1</source>
        <translation>le rapport de réduction est inconnu pour %1</translation>
    </message>
    <message>
        <source>the reduction ratio of joint %1 is unknown</source>
        <translation>le rapport de réduction de l’axe %1 est inconnu</translation>
    </message>
    <message>
        <source>the robot has %1 joints</source>
        <translation>le robot a %1 axes</translation>
    </message>
    <message>
        <source>the robot of the cell has no configurations of this name: %1</source>
        <translation>le robot de la cellule n’a pas de configurations de ce nom : %1</translation>
    </message>
    <message>
        <source>the row has %1 columns, the header %2</source>
        <translation>la ligne a %1 colonnes, l’en-tête %2</translation>
    </message>
    <message>
        <source>the section is narrower than a bead: %1 mm at %2; nothing is laid there</source>
        <translation>la section est plus étroite qu’un cordon : %1 mm en %2 ; rien n’y est déposé</translation>
    </message>
    <message>
        <source>the section is narrower than a bead: %1 mm at %2; one bead of that width is laid there</source>
        <translation>la section est plus étroite qu’un cordon : %1 mm en %2 ; un cordon de cette largeur y est déposé</translation>
    </message>
    <message>
        <source>the section is not closed, so it has no inside to fill: it ends at (%1, %2, %3)</source>
        <translation>la section n’est pas fermée, elle n’a donc pas d’intérieur à remplir : elle finit en (%1, %2, %3)</translation>
    </message>
    <message>
        <source>the smallest layer height is above the greatest</source>
        <translation>la hauteur de couche minimale est au-dessus de la maximale</translation>
    </message>
    <message>
        <source>the smallest travel speed is above the greatest</source>
        <translation>la vitesse d’avance minimale est au-dessus de la maximale</translation>
    </message>
    <message>
        <source>the source of the distance does not lie on the mesh: %1</source>
        <translation>la source de la distance n’est pas sur le maillage : %1</translation>
    </message>
    <message>
        <source>the spacing gives more than 10 million lines</source>
        <translation>l’espacement donne plus de 10 millions de lignes</translation>
    </message>
    <message>
        <source>the speed of moves to axis values needs the axis speeds of the cell</source>
        <translation>la vitesse des mouvements vers des valeurs d’axes demande les vitesses d’axes de la cellule</translation>
    </message>
    <message>
        <source>the speed ratio of a joint move is not in (0, 1]</source>
        <translation>la part de vitesse d’un mouvement d’axes n’est pas dans ]0, 1]</translation>
    </message>
    <message>
        <source>the step between insets must be above 0</source>
        <translation>le pas entre contours intérieurs doit être supérieur à 0</translation>
    </message>
    <message>
        <source>the step gives more than a million layers</source>
        <translation>le pas donne plus d’un million de couches</translation>
    </message>
    <message>
        <source>the step is not above 0</source>
        <translation>le pas n’est pas supérieur à 0</translation>
    </message>
    <message>
        <source>the step must be positive</source>
        <translation>le pas doit être positif</translation>
    </message>
    <message>
        <source>the step of %1 mm is outside the process&apos;s layer heights of %2 to %3 mm</source>
        <translation>le pas de %1 mm est hors des hauteurs de couche du procédé, de %2 à %3 mm</translation>
    </message>
    <message>
        <source>the steps of the search must be greater than 0</source>
        <translation>les pas de la recherche doivent être supérieurs à 0</translation>
    </message>
    <message>
        <source>the strategy %1 needs a file with a path</source>
        <translation>la stratégie %1 demande un fichier avec une trajectoire</translation>
    </message>
    <message>
        <source>the strategy %1 needs a guide curve</source>
        <translation>la stratégie %1 demande une courbe guide</translation>
    </message>
    <message>
        <source>the strategy %1 needs a guide curve, or set %2</source>
        <translation>la stratégie %1 demande une courbe guide, ou régler %2</translation>
    </message>
    <message>
        <source>the strategy %1 needs a part</source>
        <translation>la stratégie %1 demande une pièce</translation>
    </message>
    <message>
        <source>the strategy names layer %1 below layer %2 of %3</source>
        <translation>la stratégie nomme la couche %1 sous la couche %2 de %3</translation>
    </message>
    <message>
        <source>the sum %1 exceeds its limit by up to %2 at %3</source>
        <translation>la somme %1 dépasse sa butée de jusqu’à %2 en %3</translation>
    </message>
    <message>
        <source>the surface cannot be met exactly: %1 spans leave a distance of %2 mm</source>
        <translation>la surface ne peut être rendue exactement : %1 intervalles laissent une distance de %2 mm</translation>
    </message>
    <message>
        <source>the surface has no area or crosses itself</source>
        <translation>la surface n’a pas d’aire ou se recoupe</translation>
    </message>
    <message>
        <source>the surface has no triangles</source>
        <translation>la surface n’a pas de triangles</translation>
    </message>
    <message>
        <source>the surface has only one side (like a Möbius strip); its normals disagree at %1 mm</source>
        <translation>la surface n’a qu’un côté (comme un ruban de Möbius) ; ses normales se contredisent en %1 mm</translation>
    </message>
    <message>
        <source>the surface is a single point</source>
        <translation>la surface est un seul point</translation>
    </message>
    <message>
        <source>the surface is closed: it has no border that beads could follow</source>
        <translation>la surface est fermée : elle n’a pas de bord que des cordons pourraient suivre</translation>
    </message>
    <message>
        <source>the surface is not closed in %1: its ends are %2 mm apart</source>
        <translation>la surface n’est pas fermée en %1 : ses bouts sont à %2 mm l’un de l’autre</translation>
    </message>
    <message>
        <source>the surface is open: %1 border loops, the longest %2 mm from %3</source>
        <translation>la surface est ouverte : %1 boucles de bord, la plus longue de %2 mm depuis %3</translation>
    </message>
    <message>
        <source>the surface of part %1 is not closed; its closed sections are filled as those of a solid</source>
        <translation>la surface de la pièce %1 n’est pas fermée ; ses sections fermées sont remplies comme celles d’un solide</translation>
    </message>
    <message>
        <source>the surface runs along the planes of the beads</source>
        <translation>la surface suit les plans des cordons</translation>
    </message>
    <message>
        <source>the table holds no bead of at least two points</source>
        <translation>la table ne contient pas de cordon d’au moins deux points</translation>
    </message>
    <message>
        <source>the table of &apos;%1&apos;</source>
        <translation>la table de « %1 »</translation>
    </message>
    <message>
        <source>the time %1 s is not after %2 s of the row before</source>
        <translation>le temps %1 s n’est pas après %2 s de la ligne précédente</translation>
    </message>
    <message>
        <source>the time factor must be greater than zero</source>
        <translation>le facteur de temps doit être supérieur à zéro</translation>
    </message>
    <message>
        <source>the tolerance is negative or no number</source>
        <translation>la tolérance est négative ou n’est pas un nombre</translation>
    </message>
    <message>
        <source>the tolerance of an offset must be above 0</source>
        <translation>la tolérance d’un décalage doit être supérieure à 0</translation>
    </message>
    <message>
        <source>the tool axis leaves its rule by up to %1 degrees to turn by at most %2 degrees per mm</source>
        <translation>l’axe outil s’écarte de sa règle de jusqu’à %1 degrés pour tourner d’au plus %2 degrés par mm</translation>
    </message>
    <message>
        <source>the torch is predicted to run at %1 mm/s, %2 % of the wanted speed</source>
        <translation>la torche est prévue à %1 mm/s, %2 % de la vitesse voulue</translation>
    </message>
    <message>
        <source>the torch is predicted to run at %1 mm/s, %2 % of the wanted speed, the worst of %3 places</source>
        <translation>la torche est prévue à %1 mm/s, %2 % de la vitesse voulue, au pire de %3 endroits</translation>
    </message>
    <message>
        <source>the torch is predicted to slow down to %1 mm/s, %2 % of the wanted speed; nearest to its limit is %4</source>
        <translation>la torche est prévue ralentie à %1 mm/s, %2 % de la vitesse voulue ; le plus près de sa limite : %4</translation>
    </message>
    <message>
        <source>the torch is predicted to slow down to %1 mm/s, %2 % of the wanted speed; nearest to its limit is %4, the worst of %3 places</source>
        <translation>la torche est prévue ralentie à %1 mm/s, %2 % de la vitesse voulue, au pire de %3 endroits ; le plus près de sa limite : %4</translation>
    </message>
    <message>
        <source>the torch leans by up to %1 from the path&apos;s tool axis at %2; allowed are %3</source>
        <translation>la torche penche de jusqu’à %1 par rapport à l’axe outil de la trajectoire en %2 ; il est permis %3</translation>
    </message>
    <message>
        <source>the tube folds at t = %1: its radius reaches the guide&apos;s radius of curvature</source>
        <translation>le tube se replie à t = %1 : son rayon atteint le rayon de courbure du guide</translation>
    </message>
    <message>
        <source>the type of the surface is not &quot;parametric&quot;, &quot;tube&quot; or &quot;revolution&quot;</source>
        <translation>le type de la surface n’est pas « parametric », « tube » ou « revolution »</translation>
    </message>
    <message>
        <source>the unit is not decided</source>
        <translation>l’unité n’est pas décidée</translation>
    </message>
    <message>
        <source>the vector %1, %2, %3 has no length</source>
        <translation>le vecteur %1, %2, %3 n’a pas de longueur</translation>
    </message>
    <message>
        <source>the wall is only %1 mm high, less than the %2 mm of a layer</source>
        <translation>la paroi n’est haute que de %1 mm, moins que les %2 mm d’une couche</translation>
    </message>
    <message>
        <source>the wall of part &apos;%1&apos; is %2 to %3 mm thick, %4 mm in the mean</source>
        <translation>la paroi de la pièce « %1 » est épaisse de %2 à %3 mm, de %4 mm en moyenne</translation>
    </message>
    <message>
        <source>the wall of part &apos;%1&apos; is %2 to %3 mm thick, the bead %4 mm wide</source>
        <translation>la paroi de la pièce « %1 » est épaisse de %2 à %3 mm, le cordon large de %4 mm</translation>
    </message>
    <message>
        <source>the weights of a point do not sum to 1</source>
        <translation>les poids d’un point n’ont pas pour somme 1</translation>
    </message>
    <message>
        <source>the whole part lies below the substrate</source>
        <translation>toute la pièce est sous le substrat</translation>
    </message>
    <message>
        <source>the whole part lies in or below the substrate</source>
        <translation>toute la pièce est dans le substrat ou dessous</translation>
    </message>
    <message>
        <source>the width of a stroke is negative or no number</source>
        <translation>la largeur d’un trait est négative ou n’est pas un nombre</translation>
    </message>
    <message>
        <source>the wrist centre lies on axis 3</source>
        <translation>le centre du poignet est sur l’axe 3</translation>
    </message>
    <message>
        <source>the wrist is not spherical: axes 4 and 5 do not meet</source>
        <translation>le poignet n’est pas sphérique : les axes 4 et 5 ne se rencontrent pas</translation>
    </message>
    <message>
        <source>the wrist is not spherical: axis 6 does not pass through the wrist centre</source>
        <translation>le poignet n’est pas sphérique : l’axe 6 ne passe pas par le centre du poignet</translation>
    </message>
    <message>
        <source>there are more triangles than can be handled</source>
        <translation>il y a plus de triangles qu’il n’en peut être traité</translation>
    </message>
    <message>
        <source>there are: %1</source>
        <translation>il y a : %1</translation>
    </message>
    <message>
        <source>there is a %1 &apos;%2&apos; already</source>
        <translation>%1 « %2 » existe déjà</translation>
    </message>
    <message>
        <source>there is an edit &apos;%1&apos; already</source>
        <translation>la retouche « %1 » existe déjà</translation>
    </message>
    <message>
        <source>there is no %1 &apos;%2&apos;</source>
        <translation>%1 « %2 » n’existe pas</translation>
    </message>
    <message>
        <source>there is no edge %1</source>
        <translation>l’arête %1 n’existe pas</translation>
    </message>
    <message>
        <source>there is no generatrix</source>
        <translation>il n’y a pas de génératrice</translation>
    </message>
    <message>
        <source>there is no vertex %1</source>
        <translation>le sommet %1 n’existe pas</translation>
    </message>
    <message>
        <source>there is no vertex %1; the mesh has %2</source>
        <translation>le sommet %1 n’existe pas ; le maillage en a %2</translation>
    </message>
    <message>
        <source>there is no zero convention &apos;%1&apos;</source>
        <translation>la convention de zéro « %1 » n’existe pas</translation>
    </message>
    <message>
        <source>there is nothing to redo</source>
        <translation>il n’y a rien à rétablir</translation>
    </message>
    <message>
        <source>there is nothing to undo</source>
        <translation>il n’y a rien à annuler</translation>
    </message>
    <message>
        <source>this does not look like a cell file</source>
        <translation>ceci ne ressemble pas à un fichier de cellule</translation>
    </message>
    <message>
        <source>this is a fault of the strategy&apos;s plugin; report it to its author</source>
        <translation>c’est un défaut de l’extension de la stratégie ; le signaler à son auteur</translation>
    </message>
    <message>
        <source>this is no readable %1 file%2</source>
        <translation>ce n’est pas un fichier %1 lisible%2</translation>
    </message>
    <message>
        <source>tilt the torch by %1 about the direction of travel (exit_rotations does it)</source>
        <translation>pencher la torche de %1 autour de la direction d’avance (exit_rotations le fait)</translation>
    </message>
    <message>
        <source>tilt the torch by %1 along the travel</source>
        <translation>pencher la torche de %1 le long de l’avance</translation>
    </message>
    <message>
        <source>tilt the torch, change the rotation about it or the place of the part</source>
        <translation>pencher la torche, changer la rotation autour d’elle ou la place de la pièce</translation>
    </message>
    <message>
        <source>time</source>
        <translation>temps</translation>
    </message>
    <message>
        <source>tolerance or least turn is out of range</source>
        <translation>tolérance ou angle minimal hors du domaine</translation>
    </message>
    <message>
        <source>tolerance, angle or least length is out of range</source>
        <translation>tolérance, angle ou longueur minimale hors du domaine</translation>
    </message>
    <message>
        <source>topology of a field</source>
        <translation>topologie d’un champ</translation>
    </message>
    <message>
        <source>torch %1</source>
        <translation>torche %1</translation>
    </message>
    <message>
        <source>triangle %1 does not exist</source>
        <translation>le triangle %1 n’existe pas</translation>
    </message>
    <message>
        <source>triangle %1 has a coordinate that is not a number</source>
        <translation>le triangle %1 a une coordonnée qui n’est pas un nombre</translation>
    </message>
    <message>
        <source>triangle %1 refers to a vertex that does not exist</source>
        <translation>le triangle %1 renvoie à un sommet qui n’existe pas</translation>
    </message>
    <message>
        <source>trim or remove this face in the CAD system</source>
        <translation>limiter ou supprimer cette face dans le système CAO</translation>
    </message>
    <message>
        <source>try again</source>
        <translation>réessayer</translation>
    </message>
    <message>
        <source>turn fraction</source>
        <translation>fraction de tour</translation>
    </message>
    <message>
        <source>turn the part on the table by %1</source>
        <translation>tourner la pièce sur le plateau de %1</translation>
    </message>
    <message>
        <source>turn the part with a positioner, or let planes across the build direction cut it</source>
        <translation>tourner la pièce avec un positionneur, ou la laisser couper par des plans en travers de la direction de construction</translation>
    </message>
    <message>
        <source>two borders with different values share the point %1, %2, %3</source>
        <translation>deux bords de valeurs différentes partagent le point %1, %2, %3</translation>
    </message>
    <message>
        <source>two consecutive points of curve %1 share no triangle</source>
        <translation>deux points consécutifs de la courbe %1 ne partagent pas de triangle</translation>
    </message>
    <message>
        <source>type %1 is not known</source>
        <translation>le type %1 n’est pas connu</translation>
    </message>
    <message>
        <source>undo</source>
        <translation>annuler</translation>
    </message>
    <message>
        <source>unit %1 is not known</source>
        <translation>l’unité %1 n’est pas connue</translation>
    </message>
    <message>
        <source>unknown CAD format</source>
        <translation>format CAO inconnu</translation>
    </message>
    <message>
        <source>use %1, numbers, pi, + - * / ^ and functions like sin, sqrt, exp</source>
        <translation>utiliser %1, des nombres, pi, + - * / ^ et des fonctions comme sin, sqrt, exp</translation>
    </message>
    <message>
        <source>use a cell with a FANUC robot</source>
        <translation>utiliser une cellule avec un robot FANUC</translation>
    </message>
    <message>
        <source>use a cell with a KUKA robot</source>
        <translation>utiliser une cellule avec un robot KUKA</translation>
    </message>
    <message>
        <source>use a cell with a positioner, or the mode optimized, constant, point_by_point or polynomial</source>
        <translation>utiliser une cellule avec un positionneur, ou le mode optimized, constant, point_by_point ou polynomial</translation>
    </message>
    <message>
        <source>use a finer mesh</source>
        <translation>utiliser un maillage plus fin</translation>
    </message>
    <message>
        <source>use a narrower bead, or allow narrower or shorter beads (min_width, min_length)</source>
        <translation>utiliser un cordon plus étroit, ou permettre des cordons plus étroits ou plus courts (min_width, min_length)</translation>
    </message>
    <message>
        <source>use a narrower bead, or allow shorter ones (min_length)</source>
        <translation>utiliser un cordon plus étroit, ou en permettre de plus courts (min_length)</translation>
    </message>
    <message>
        <source>use a newer program</source>
        <translation>utiliser un programme plus récent</translation>
    </message>
    <message>
        <source>use a polyline or a formula</source>
        <translation>utiliser une polyligne ou une formule</translation>
    </message>
    <message>
        <source>use a polyline or a formula as guide</source>
        <translation>utiliser une polyligne ou une formule comme guide</translation>
    </message>
    <message>
        <source>use a post-processor for Cartesian machines</source>
        <translation>utiliser un post-processeur pour machines cartésiennes</translation>
    </message>
    <message>
        <source>use a smaller radius or a straighter guide</source>
        <translation>utiliser un rayon plus petit ou un guide plus droit</translation>
    </message>
    <message>
        <source>use an edge length of %1 mm or more</source>
        <translation>utiliser une longueur d’arête de %1 mm ou plus</translation>
    </message>
    <message>
        <source>use curved layers there, or a process with thinner layers</source>
        <translation>y utiliser des couches courbes, ou un procédé à couches plus minces</translation>
    </message>
    <message>
        <source>use fewer or thinner layers there</source>
        <translation>y utiliser moins de couches ou des couches plus minces</translation>
    </message>
    <message>
        <source>use linear moves inside a bead</source>
        <translation>utiliser des mouvements linéaires dans un cordon</translation>
    </message>
    <message>
        <source>use numbers, pi, + - * / ^ and functions like sin, sqrt, exp</source>
        <translation>utiliser des nombres, pi, + - * / ^ et des fonctions comme sin, sqrt, exp</translation>
    </message>
    <message>
        <source>use speeds up to 3 m/s, and more decimals for slow ones</source>
        <translation>utiliser des vitesses jusqu’à 3 m/s, et plus de décimales pour les lentes</translation>
    </message>
    <message>
        <source>use the CAD file of the part, or slice at constant distance</source>
        <translation>utiliser le fichier CAO de la pièce, ou trancher à distance constante</translation>
    </message>
    <message>
        <source>use the configuration %1</source>
        <translation>utiliser la configuration %1</translation>
    </message>
    <message>
        <source>use the configuration %1 and rotate the torch about its axis by %2</source>
        <translation>utiliser la configuration %1 et tourner la torche autour de son axe de %2</translation>
    </message>
    <message>
        <source>use the faces of the wall as working surface</source>
        <translation>utiliser les faces de la paroi comme surface de travail</translation>
    </message>
    <message>
        <source>use the iso-value decomposition</source>
        <translation>utiliser la décomposition par iso-valeurs</translation>
    </message>
    <message>
        <source>use the iso-value or the geodesic decomposition</source>
        <translation>utiliser la décomposition par iso-valeurs ou géodésique</translation>
    </message>
    <message>
        <source>use the newer version of WCAM</source>
        <translation>utiliser la version plus récente de WCAM</translation>
    </message>
    <message>
        <source>use the newer version of WCAM; `camcli info` shows what is in the project</source>
        <translation>utiliser la version plus récente de WCAM ; « camcli info » montre ce qu’il y a dans le projet</translation>
    </message>
    <message>
        <source>vertex %1 does not exist</source>
        <translation>le sommet %1 n’existe pas</translation>
    </message>
    <message>
        <source>vertex %1 has %2 instead of a finite number</source>
        <translation>le sommet %1 a %2 au lieu d’un nombre fini</translation>
    </message>
    <message>
        <source>vertices %1 and %2 share no edge</source>
        <translation>les sommets %1 et %2 ne partagent pas d’arête</translation>
    </message>
    <message>
        <source>voltage</source>
        <translation>tension</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volume</translation>
    </message>
    <message>
        <source>wall</source>
        <translation>paroi</translation>
    </message>
    <message>
        <source>walls</source>
        <translation>parois</translation>
    </message>
    <message>
        <source>weights must be finite and greater than zero</source>
        <translation>les poids doivent être finis et supérieurs à zéro</translation>
    </message>
    <message>
        <source>widen the range, lower the deposit, or start without ramps</source>
        <translation>élargir le domaine, baisser le dépôt, ou commencer sans rampes</translation>
    </message>
    <message>
        <source>wire_speed</source>
        <translation>vitesse de fil</translation>
    </message>
    <message>
        <source>working surface of a solid wall</source>
        <translation>surface de travail d’une paroi épaisse</translation>
    </message>
    <message>
        <source>wrist singularity: axes 4 and 6 are in line but for %1 at %2</source>
        <translation>singularité du poignet : les axes 4 et 6 sont alignés à %1 près en %2</translation>
    </message>
    <message>
        <source>write &quot;frame&quot;: &quot;minimal&quot;</source>
        <translation>écrire « frame » : « minimal »</translation>
    </message>
    <message>
        <source>write &apos;/&apos; between folders</source>
        <translation>écrire « / » entre les dossiers</translation>
    </message>
    <message>
        <source>write KEY, ID.KEY or ID.SECTION.KEY; `camcli schema` lists the parameters</source>
        <translation>écrire KEY, ID.KEY ou ID.SECTION.KEY ; « camcli schema » énumère les paramètres</translation>
    </message>
    <message>
        <source>write KEY=VALUE, for example step=2.5mm</source>
        <translation>écrire KEY=VALUE, par exemple step=2.5mm</translation>
    </message>
    <message>
        <source>write NUMBER=METHOD with commas between, as in &apos;1=spiral, 3=isovalues&apos;, or *=METHOD; methods: common, geodesic, isovalues, spiral</source>
        <translation>écrire NUMÉRO=MÉTHODE séparés par des virgules, comme « 1=spiral, 3=isovalues », ou *=MÉTHODE ; méthodes : common, geodesic, isovalues, spiral</translation>
    </message>
    <message>
        <source>write a header line and one row per sample</source>
        <translation>écrire une ligne d’en-tête et une ligne par échantillon</translation>
    </message>
    <message>
        <source>write a number with one of: %1</source>
        <translation>écrire un nombre avec une de : %1</translation>
    </message>
    <message>
        <source>write a plain number</source>
        <translation>écrire un simple nombre</translation>
    </message>
    <message>
        <source>write it like 010, or leave it empty</source>
        <translation>l’écrire comme 010, ou le laisser vide</translation>
    </message>
    <message>
        <source>write it like NUT</source>
        <translation>l’écrire comme NUT</translation>
    </message>
    <message>
        <source>write one cell per column</source>
        <translation>écrire une cellule par colonne</translation>
    </message>
    <message>
        <source>write one of: %1</source>
        <translation>écrire un de : %1</translation>
    </message>
    <message>
        <source>write one of: %1, %2</source>
        <translation>écrire un de : %1, %2</translation>
    </message>
    <message>
        <source>write one row per point, with the arc on</source>
        <translation>écrire une ligne par point, arc allumé</translation>
    </message>
    <message>
        <source>write plain numbers with a decimal point</source>
        <translation>écrire de simples nombres avec un point décimal</translation>
    </message>
    <message>
        <source>write speeds in cm/min or with more decimals</source>
        <translation>écrire les vitesses en cm/min ou avec plus de décimales</translation>
    </message>
    <message>
        <source>write the axes with more digits or as angles</source>
        <translation>écrire les axes avec plus de chiffres ou en angles</translation>
    </message>
    <message>
        <source>write them as {&quot;params&quot;: {...}}; `camcli schema process` lists them</source>
        <translation>les écrire comme {&quot;params&quot;: {...}} ; « camcli schema process » les énumère</translation>
    </message>
    <message>
        <source>write x y z in mm, one point per line</source>
        <translation>écrire x y z en mm, un point par ligne</translation>
    </message>
    <message>
        <source>wrote no file</source>
        <translation>n’a écrit aucun fichier</translation>
    </message>
    <message>
        <source>Highest corner</source>
        <translation>Coin le plus haut</translation>
    </message>
    <message>
        <source>Lowest corner</source>
        <translation>Coin le plus bas</translation>
    </message>
    <message>
        <source>Mean of (1 - dexterity) squared.</source>
        <translation>Moyenne de (1 - dextérité) au carré.</translation>
    </message>
    <message>
        <source>Mean of the squared distance from the middle over half the stroke, all joints.</source>
        <translation>Moyenne du carré de la distance au milieu sur la demi-course, tous les axes.</translation>
    </message>
    <message>
        <source>Mean square angle between build direction and vertical, in degrees.</source>
        <translation>Angle quadratique moyen entre direction de construction et verticale, en degrés.</translation>
    </message>
    <message>
        <source>Mean square in micrometres (Chalvin A34).</source>
        <translation>Moyenne quadratique en micromètres (Chalvin A34).</translation>
    </message>
    <message>
        <source>Mean square of acceleration over its maximum, at the wanted travel speed.</source>
        <translation>Moyenne quadratique de l’accélération sur son maximum, à la vitesse d’avance voulue.</translation>
    </message>
    <message>
        <source>Mean square of jerk over its maximum, at the wanted travel speed.</source>
        <translation>Moyenne quadratique du jerk sur son maximum, à la vitesse d’avance voulue.</translation>
    </message>
    <message>
        <source>Mean square of speed over its maximum, at the wanted travel speed.</source>
        <translation>Moyenne quadratique de la vitesse sur son maximum, à la vitesse d’avance voulue.</translation>
    </message>
    <message>
        <source>Of the box.</source>
        <translation>De la boîte.</translation>
    </message>
    <message>
        <source>Points to the side that is meant.</source>
        <translation>Pointe vers le côté visé.</translation>
    </message>
    <message>
        <source>Sum of squared joint moves over strokes, in degrees.</source>
        <translation>Somme des carrés des mouvements d’axes sur les courses, en degrés.</translation>
    </message>
    <message>
        <source>Sum of squared joint steps over strokes, in degrees (Chalvin Eq. 4.3).</source>
        <translation>Somme des carrés des pas d’axes sur les courses, en degrés (Chalvin Éq. 4.3).</translation>
    </message>
    <message>
        <source>Sum of squared steps of endless robot joints over 360 degrees; torch carried only.</source>
        <translation>Somme des carrés des pas des axes sans fin du robot sur 360 degrés ; torche portée seulement.</translation>
    </message>
    <message>
        <source>Sum of squared steps over 360 degrees.</source>
        <translation>Somme des carrés des pas sur 360 degrés.</translation>
    </message>
    <message>
        <source>Weight of constant TCP speed</source>
        <translation>Poids de la vitesse TCP constante</translation>
    </message>
    <message>
        <source>Weight of dexterity</source>
        <translation>Poids de la dextérité</translation>
    </message>
    <message>
        <source>Weight of joint accelerations</source>
        <translation>Poids des accélérations d’axes</translation>
    </message>
    <message>
        <source>Weight of joint jerks</source>
        <translation>Poids des jerks d’axes</translation>
    </message>
    <message>
        <source>Weight of joint speeds</source>
        <translation>Poids des vitesses d’axes</translation>
    </message>
    <message>
        <source>Weight of moves between beads</source>
        <translation>Poids des mouvements entre cordons</translation>
    </message>
    <message>
        <source>Weight of positioning uncertainty</source>
        <translation>Poids de l’incertitude de position</translation>
    </message>
    <message>
        <source>Weight of the distance to limits</source>
        <translation>Poids de la distance aux butées</translation>
    </message>
    <message>
        <source>Weight of the positioner&apos;s motion</source>
        <translation>Poids du mouvement du positionneur</translation>
    </message>
    <message>
        <source>Weight of the robot&apos;s motion</source>
        <translation>Poids du mouvement du robot</translation>
    </message>
    <message>
        <source>Weight of the vertical</source>
        <translation>Poids de la verticale</translation>
    </message>
    <message>
        <source>Weight of winding the cable</source>
        <translation>Poids de l’enroulement du câble</translation>
    </message>
    <message>
        <source>Across the travel; positive leans to the side of the bead&apos;s normal.</source>
        <translation>En travers de l’avance ; positif penche du côté de la normale du cordon.</translation>
    </message>
    <message>
        <source>In the travel plane; positive leans forward.</source>
        <translation>Dans le plan de l’avance ; positif penche vers l’avant.</translation>
    </message>
    <message>
        <source>an unknown exception</source>
        <translation>une exception inconnue</translation>
    </message>
    <message>
        <source>please report this with the project file</source>
        <translation>merci de le signaler avec le fichier de projet</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>la mémoire ne suffit pas</translation>
    </message>
    <message>
        <source>unexpected</source>
        <translation>inattendu</translation>
    </message>
    <message>
        <source>use a coarser part or step</source>
        <translation>utiliser une pièce ou un pas plus grossier</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1 ; %2</translation>
    </message>
    <message>
        <source>reading the CAD file</source>
        <translation>lecture du fichier CAO</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>writing the STEP file</source>
        <translation>écriture du fichier STEP</translation>
    </message>
    <message>
        <source>max</source>
        <translation>max</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <source>Around an axis</source>
        <translation>Autour d&apos;un axe</translation>
    </message>
    <message>
        <source>Branching parts</source>
        <translation>Pièces ramifiées</translation>
    </message>
    <message>
        <source>Cladding of a surface</source>
        <translation>Rechargement d&apos;une surface</translation>
    </message>
    <message>
        <source>Comma separated values</source>
        <translation>Valeurs séparées par des virgules</translation>
    </message>
    <message>
        <source>Constant inter-layer distance</source>
        <translation>Distance inter-couches constante</translation>
    </message>
    <message>
        <source>Continuous spiral</source>
        <translation>Spirale continue</translation>
    </message>
    <message>
        <source>FANUC TP (.LS)</source>
        <translation>FANUC TP (.LS)</translation>
    </message>
    <message>
        <source>Filled planar layers</source>
        <translation>Couches planes remplies</translation>
    </message>
    <message>
        <source>Geodesic distance from the base</source>
        <translation>Distance géodésique depuis la base</translation>
    </message>
    <message>
        <source>Imported path</source>
        <translation>Trajectoire importée</translation>
    </message>
    <message>
        <source>Iso-parametric</source>
        <translation>Isoparamétrique</translation>
    </message>
    <message>
        <source>Iso-values between the borders</source>
        <translation>Isovaleurs entre les bords</translation>
    </message>
    <message>
        <source>KUKA KRL (.src)</source>
        <translation>KUKA KRL (.src)</translation>
    </message>
    <message>
        <source>Normal to a guide</source>
        <translation>Normale à une courbe guide</translation>
    </message>
    <message>
        <source>Planar slicing</source>
        <translation>Tranchage plan</translation>
    </message>
    <message>
        <source>%1 to %2 mm</source>
        <translation>%1 à %2 mm</translation>
    </message>
    <message>
        <source>%1; tried on the whole operation, it does not help by itself</source>
        <translation>%1&#xa0;; essayé sur toute l’opération, cela ne suffit pas seul</translation>
    </message>
    <message>
        <source>%1; tried on the whole operation: %2 of %3 violations are left</source>
        <translation>%1&#xa0;; essayé sur toute l’opération&#xa0;: il reste %2 des %3 non-conformités</translation>
    </message>
    <message>
        <source>%1; tried on the whole operation: no violation is left</source>
        <translation>%1&#xa0;; essayé sur toute l’opération&#xa0;: il ne reste aucune non-conformité</translation>
    </message>
    <message>
        <source>Counted from 0 in files, from 1 in the window; negative numbers count from the top, whose layer is -1.</source>
        <translation>Compté à partir de 0 dans les fichiers, de 1 dans la fenêtre&#xa0;; les nombres négatifs comptent depuis le haut, dont la couche est -1.</translation>
    </message>
    <message>
        <source>Counted in each layer, from 0 in files, from 1 in the window; -1 is all beads.</source>
        <translation>Compté dans chaque couche, à partir de 0 dans les fichiers, de 1 dans la fenêtre&#xa0;; -1 désigne tous les cordons.</translation>
    </message>
    <message>
        <source>a hint: %1, which serves %2 of %3 points tried of this bead</source>
        <translation>une piste&#xa0;: %1, ce qui convient à %2 des %3 points essayés de ce cordon</translation>
    </message>
    <message>
        <source>a hint: %1, which serves %2 of %3 points tried of this bead (reach, limits and singularities; collisions not looked at)</source>
        <translation>une piste&#xa0;: %1, ce qui convient à %2 des %3 points essayés de ce cordon (portée, butées et singularités&#xa0;; sans les collisions)</translation>
    </message>
    <message>
        <source>a hint: %1, which serves all points tried of this bead</source>
        <translation>une piste&#xa0;: %1, ce qui convient à tous les points essayés de ce cordon</translation>
    </message>
    <message>
        <source>a hint: %1, which serves all points tried of this bead (reach, limits and singularities; collisions not looked at)</source>
        <translation>une piste&#xa0;: %1, ce qui convient à tous les points essayés de ce cordon (portée, butées et singularités&#xa0;; sans les collisions)</translation>
    </message>
    <message>
        <source>a process whose heights go from %1 would do</source>
        <translation>un procédé dont les hauteurs vont de %1 conviendrait</translation>
    </message>
    <message>
        <source>a wider modulation range or another decomposition may help</source>
        <translation>une plage de modulation plus large ou une autre décomposition peut aider</translation>
    </message>
    <message>
        <source>no range about this deposit does on this part: another decomposition or another mean deposit may help</source>
        <translation>aucune plage autour de cette hauteur déposée ne convient à cette pièce&#xa0;: une autre décomposition ou une autre hauteur déposée moyenne peut aider</translation>
    </message>
    <message>
        <source>no range about this deposit does: build the piece in layers</source>
        <translation>aucune plage autour de cette hauteur déposée ne convient&#xa0;: construire ce tronçon par couches</translation>
    </message>
    <message>
        <source>set exit_rotations, which tilts the torch out of collisions</source>
        <translation>activer exit_rotations, qui incline la torche hors des collisions</translation>
    </message>
    <message>
        <source>set the modulation range to %1; this was tried</source>
        <translation>régler la plage de modulation sur %1&#xa0;; cela a été essayé</translation>
    </message>
    <message>
        <source>set the rotation about the torch to %1 deg</source>
        <translation>régler la rotation autour de la torche sur %1 deg</translation>
    </message>
    <message>
        <source>take the cell &quot;%1&quot;</source>
        <translation>prendre la cellule «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>use the configuration %1 and a rotation of %2 deg about the torch</source>
        <translation>utiliser la configuration %1 et une rotation de %2 deg autour de la torche</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a word of the language or of the file system: the program is named %2</source>
        <translation>« %1 » est un mot du langage ou du système de fichiers : le programme s’appelle %2</translation>
    </message>
    <message>
        <source>0: no limit. A longer operation is cut between beads into programs that a main program calls; each of them can be started alone.</source>
        <translation>0 : sans limite. Une opération plus longue est coupée entre les cordons en programmes qu’un programme principal appelle ; chacun d’eux peut être lancé seul.</translation>
    </message>
    <message>
        <source>A longer operation is cut between beads into programs that a main program calls; each of them can be started alone.</source>
        <translation>Une opération plus longue est coupée entre les cordons en programmes qu’un programme principal appelle ; chacun d’eux peut être lancé seul.</translation>
    </message>
    <message>
        <source>A variable of the controller that takes m/min; empty: the job decides alone, and operations whose wire speed changes get no program.</source>
        <translation>Une variable de la commande en m/min ; vide : le job décide seul, et les opérations dont la vitesse de fil change n’ont pas de programme.</translation>
    </message>
    <message>
        <source>Adds RTCP to linear and circular moves when the robot carries the part, so that the speed holds at the torch. It excludes coordinated motion.</source>
        <translation>Ajoute RTCP aux mouvements linéaires et circulaires quand le robot porte la pièce : la vitesse est tenue à la torche. Exclut le mouvement coordonné.</translation>
    </message>
    <message>
        <source>As the points. 0: no limit.</source>
        <translation>Comme les points. 0 : sans limite.</translation>
    </message>
    <message>
        <source>As the points. Line numbers above 9999 need five digits, which many controllers do not read. 0: no limit.</source>
        <translation>Comme les points. Au-delà de 9999 les numéros de ligne ont cinq chiffres, que bien des commandes ne lisent pas. 0 : sans limite.</translation>
    </message>
    <message>
        <source>Axis values</source>
        <translation>Valeurs d’axes</translation>
    </message>
    <message>
        <source>Axis values say how the robot reaches a point. Cartesian positions carry status and turn bits (S and T) instead; where an axis is within 0.001 degrees of 0, its turn bit would be chance, and axis values are written all the same.</source>
        <translation>Les valeurs d’axes disent comment le robot atteint un point. Les positions cartésiennes portent à la place les bits d’état et de tour (S et T) ; quand un axe est à moins de 0,001 degré de 0, son bit de tour serait dû au hasard, et des valeurs d’axes sont écrites malgré tout.</translation>
    </message>
    <message>
        <source>Cartesian with S and T</source>
        <translation>Cartésien avec S et T</translation>
    </message>
    <message>
        <source>Cartesian: LIN with the speed of the tool. Joint values: every move is a PTP to axis values, whose speed is whole percents of the axis speeds, far above those of a bead: a dry run that checks the reach, with the arc off.</source>
        <translation>Cartésien : LIN avec la vitesse de l’outil. Valeurs d’axes : chaque mouvement est un PTP vers des valeurs d’axes, dont la vitesse est un pourcentage entier des vitesses d’axes, bien au-delà de celle d’un cordon : un essai à vide qui vérifie l’accessibilité, arc éteint.</translation>
    </message>
    <message>
        <source>Holds the torch; of a part that the robot carries, the table with the part. The head of the program says the values that were planned with.</source>
        <translation>Contient la torche ; pour une pièce que le robot porte, la table avec la pièce. L’en-tête du programme donne les valeurs de la planification.</translation>
    </message>
    <message>
        <source>Joint values (dry run)</source>
        <translation>Valeurs d’axes (essai à vide)</translation>
    </message>
    <message>
        <source>Lines per program</source>
        <translation>Lignes par programme</translation>
    </message>
    <message>
        <source>Of layers and beads. The head of a program always says what it was planned with.</source>
        <translation>Des couches et des cordons. L’en-tête d’un programme dit toujours avec quoi il a été planifié.</translation>
    </message>
    <message>
        <source>Positions of PTP moves</source>
        <translation>Positions des mouvements PTP</translation>
    </message>
    <message>
        <source>Tool frame (UT)</source>
        <translation>Repère outil (UT)</translation>
    </message>
    <message>
        <source>User frame of the fixed torch (UF)</source>
        <translation>Repère utilisateur de la torche fixe (UF)</translation>
    </message>
    <message>
        <source>a bead is longer than one program: the arc stops and starts again at %1 places in it</source>
        <translation>un cordon dépasse un programme : l’arc s’y arrête et reprend à %1 endroits</translation>
    </message>
    <message>
        <source>allow at least %1 positions and %2 lines per program</source>
        <translation>autoriser au moins %1 positions et %2 lignes par programme</translation>
    </message>
    <message>
        <source>allow more points or lines per program, or sample the bead less densely</source>
        <translation>autoriser plus de points ou de lignes par programme, ou échantillonner le cordon moins densément</translation>
    </message>
    <message>
        <source>for a part that the robot carries, the base is the fixed torch, and $NULLFRAME is not</source>
        <translation>pour une pièce que le robot porte, la base est la torche fixe, et $NULLFRAME ne l’est pas</translation>
    </message>
    <message>
        <source>measure the torch as a base and set base to its number</source>
        <translation>mesurer la torche comme base et donner son numéro à base</translation>
    </message>
    <message>
        <source>moves to axis values cannot keep the speed of a bead: the program is a dry run and leaves the arc off</source>
        <translation>des mouvements vers des valeurs d’axes ne tiennent pas la vitesse d’un cordon : le programme est un essai à vide et laisse l’arc éteint</translation>
    </message>
    <message>
        <source>moves to axis values run at whole percents of the axis speeds, up to %1 % off the planned speed</source>
        <translation>les mouvements vers des valeurs d’axes vont à des pourcentages entiers des vitesses d’axes, jusqu’à %1 % d’écart avec la vitesse prévue</translation>
    </message>
    <message>
        <source>n of BASE_DATA[n]; 0 writes $NULLFRAME. Positions are complete: with a coupled positioner the base must be its table frame, with a part that the robot carries the fixed torch (never 0), else the robot base.</source>
        <translation>n de BASE_DATA[n] ; 0 écrit $NULLFRAME. Les positions sont complètes : avec un positionneur couplé la base doit être le repère de sa table, avec une pièce que le robot porte la torche fixe (jamais 0), sinon la base du robot.</translation>
    </message>
    <message>
        <source>n of R[n], in m/min; 0: the job decides alone, and operations whose wire speed changes get no program.</source>
        <translation>n de R[n], en m/min ; 0 : le job décide seul, et les opérations dont la vitesse de fil change n’ont pas de programme.</translation>
    </message>
    <message>
        <source>n of TOOL_DATA[n]: the torch; of a part that the robot carries, the table with the part. The head of the program says the values that were planned with.</source>
        <translation>n de TOOL_DATA[n] : la torche ; pour une pièce que le robot porte, la table avec la pièce. L’en-tête du programme donne les valeurs de la planification.</translation>
    </message>
    <message>
        <source>n of UFRAME[n] for programs of a part that the robot carries: it must hold the fixed torch, with z from the part towards it. Never 0: RTCP moves relative to a user frame, and frame 0 is the robot&apos;s own, which cannot be set.</source>
        <translation>n de UFRAME[n] pour les programmes d’une pièce que le robot porte : il doit contenir la torche fixe, z allant de la pièce vers elle. Jamais 0 : RTCP se déplace par rapport à un repère utilisateur, et le repère 0 est celui du robot, qui ne se règle pas.</translation>
    </message>
    <message>
        <source>name it in the cell file (robot.controller)</source>
        <translation>la nommer dans le fichier de cellule (robot.controller)</translation>
    </message>
    <message>
        <source>name the register that hands the wire speed to the welding source (wire_register), or plan with one wire speed: ramps and edits that keep it, wire_follows_speed off</source>
        <translation>nommer le registre qui transmet la vitesse de fil au générateur (wire_register), ou planifier avec une seule vitesse de fil : rampes et modifications qui la gardent, wire_follows_speed désactivé</translation>
    </message>
    <message>
        <source>name the variable that hands the wire speed to the welding source (wire_variable), or plan with one wire speed: ramps and edits that keep it, wire_follows_speed off</source>
        <translation>nommer la variable qui transmet la vitesse de fil au générateur (wire_variable), ou planifier avec une seule vitesse de fil : rampes et modifications qui la gardent, wire_follows_speed désactivé</translation>
    </message>
    <message>
        <source>output &apos;%1&apos;: %2</source>
        <translation>sortie « %1 » : %2</translation>
    </message>
    <message>
        <source>set program_name to another name</source>
        <translation>donner un autre nom à program_name</translation>
    </message>
    <message>
        <source>the cell does not name its controller; the program is written for %1</source>
        <translation>la cellule ne nomme pas sa commande ; le programme est écrit pour %1</translation>
    </message>
    <message>
        <source>the controller of the cell is %1, the program is written for %2</source>
        <translation>la commande de la cellule est %1, le programme est écrit pour %2</translation>
    </message>
    <message>
        <source>the wire speed changes %1 times, between %2 and %3 m/min, and the program does not write it</source>
        <translation>la vitesse de fil change %1 fois, entre %2 et %3 m/min, et le programme ne l’écrit pas</translation>
    </message>
    <message>
        <source>write speeds in cm/min (speed_unit) or with more decimals (speed_decimals)</source>
        <translation>écrire les vitesses en cm/min (speed_unit) ou avec plus de décimales (speed_decimals)</translation>
    </message>
    <message>
        <source>the speeds of the program differ from the planned ones by up to %1 %</source>
        <translation>les vitesses du programme s’écartent de celles prévues jusqu’à %1 %</translation>
    </message>
    <message>
        <source>The torch leans to the side; positive leans outwards.</source>
        <translation>La torche s’incline sur le côté ; une valeur positive l’incline vers l’extérieur.</translation>
    </message>
    <message>
        <source>%1 mm² (%2 %) of the surface of part %3 get no layer; the place at (%4, %5, %6) is %7 mm from the nearest bead</source>
        <translation>%1 mm² (%2 %) de la surface de la pièce %3 ne reçoivent aucune couche ; l’endroit en (%4, %5, %6) est à %7 mm du cordon le plus proche</translation>
    </message>
    <message>
        <source>Fit the step to the height</source>
        <translation>Ajuster le pas à la hauteur</translation>
    </message>
    <message>
        <source>Leave the rest</source>
        <translation>Laisser le reste</translation>
    </message>
    <message>
        <source>Where the part&apos;s height is no whole number of steps: fit changes the step a little, so that the last layer lies on the part&apos;s end; leave keeps the step and says how much of the part is left above the last layer.</source>
        <translation>Quand la hauteur de la pièce n’est pas un nombre entier de pas : fit change un peu le pas pour que la dernière couche soit à la fin de la pièce ; leave garde le pas et indique ce qui reste de la pièce au-dessus de la dernière couche.</translation>
    </message>
    <message>
        <source>a step of %1 mm ends on the part&apos;s end</source>
        <translation>un pas de %1 mm s’achève à la fin de la pièce</translation>
    </message>
    <message>
        <source>check these faces in the CAD system, or export them divided in halves</source>
        <translation>vérifier ces faces dans la CAO, ou les exporter coupées en deux</translation>
    </message>
    <message>
        <source>choose the other parameter (direction=u or v), pick the faces to build, or slice by the geodesic distance from the base</source>
        <translation>choisir l’autre paramètre (direction=u ou v), désigner les faces à construire, ou trancher par la distance géodésique depuis la base</translation>
    </message>
    <message>
        <source>clad these faces: strategy &apos;Cladding of a surface&apos; (wcam.slicing.cladding)</source>
        <translation>recharger ces faces : stratégie « Rechargement d’une surface » (wcam.slicing.cladding)</translation>
    </message>
    <message>
        <source>closed faces were divided, since %1 could not be tessellated whole</source>
        <translation>les faces fermées ont été divisées, car %1 ne se laissaient pas mailler entières</translation>
    </message>
    <message>
        <source>fill the layers of a solid: strategy &apos;Filled planar layers&apos; (wcam.slicing.bulk)</source>
        <translation>remplir les couches d’un solide : stratégie « Couches planes remplies » (wcam.slicing.bulk)</translation>
    </message>
    <message>
        <source>let the layers follow the surface: strategy &apos;Geodesic distance from the base&apos; (wcam.slicing.geodesic), or clad level faces (wcam.slicing.cladding)</source>
        <translation>laisser les couches suivre la surface : stratégie « Distance géodésique depuis la base » (wcam.slicing.geodesic), ou recharger les faces horizontales (wcam.slicing.cladding)</translation>
    </message>
    <message>
        <source>part %1 goes on for %2 mm above its last layer</source>
        <translation>la pièce %1 continue sur %2 mm au-dessus de sa dernière couche</translation>
    </message>
    <message>
        <source>part %1 reaches %2 mm below the plate; what lies there gets no layers</source>
        <translation>la pièce %1 descend à %2 mm sous la plaque ; ce qui s’y trouve ne reçoit aucune couche</translation>
    </message>
    <message>
        <source>part %1 reaches %2 mm into the substrate; what lies there gets no layers</source>
        <translation>la pièce %1 pénètre de %2 mm dans le substrat ; ce qui s’y trouve ne reçoit aucune couche</translation>
    </message>
    <message>
        <source>split the range where the formula has a corner or a vertical tangent, if that is not near enough</source>
        <translation>diviser l’intervalle là où la formule a un coin ou une tangente verticale, si ce n’est pas assez proche</translation>
    </message>
    <message>
        <source>the seams of %1 faces were straightened, since they could not be tessellated as they are</source>
        <translation>les coutures de %1 faces ont été redressées, car elles ne se laissaient pas mailler telles quelles</translation>
    </message>
    <message>
        <source>the step is %1 mm instead of %2 mm, so that the last layer lies on the part&apos;s end</source>
        <translation>le pas est de %1 mm au lieu de %2 mm, pour que la dernière couche soit à la fin de la pièce</translation>
    </message>
    <message>
        <source>the surface follows its formula within %1 mm</source>
        <translation>la surface suit sa formule à %1 mm près</translation>
    </message>
    <message>
        <source>the iso-parametric curves run over the surface more than once: they meet each other or return to where they began</source>
        <translation>les courbes isoparamétriques parcourent la surface plus d’une fois : elles se rencontrent ou reviennent à leur départ</translation>
    </message>
    <message>
        <source>%1 bodies meet around %2 mm and cannot be united, since a surface crosses itself or has too many triangles; where they overlap, paths fill the space more than once</source>
        <translation>%1 corps se rencontrent vers %2 mm et ne peuvent pas être réunis, car une surface se recoupe ou a trop de triangles ; là où ils se recouvrent, les trajectoires remplissent l&apos;espace plusieurs fois</translation>
    </message>
    <message>
        <source>%1 bodies overlap by %2 mm³, first around %3 mm; paths fill this space more than once</source>
        <translation>%1 corps se recouvrent de %2 mm³, d&apos;abord vers %3 mm ; les trajectoires remplissent cet espace plusieurs fois</translation>
    </message>
    <message>
        <source>%1 bodies overlap by %2 mm³, first around %3 mm; they were united, so that this material counts once</source>
        <translation>%1 corps se recouvrent de %2 mm³, d&apos;abord vers %3 mm ; ils ont été réunis, cette matière ne compte qu&apos;une fois</translation>
    </message>
    <message>
        <source>%1 calls of other files in the OBJ file are not followed</source>
        <translation>%1 appels d&apos;autres fichiers dans le fichier OBJ ne sont pas suivis</translation>
    </message>
    <message>
        <source>%1 free-form curves and surfaces of the OBJ file are left out</source>
        <translation>%1 courbes et surfaces gauches du fichier OBJ sont laissées de côté</translation>
    </message>
    <message>
        <source>%1 has %2 instead of a finite number</source>
        <translation>%1 contient %2 au lieu d&apos;un nombre fini</translation>
    </message>
    <message>
        <source>%1 has %2, which is too large</source>
        <translation>%1 contient %2, ce qui est trop grand</translation>
    </message>
    <message>
        <source>%1 has a coordinate of %2, which is too large</source>
        <translation>%1 a une coordonnée de %2, ce qui est trop grand</translation>
    </message>
    <message>
        <source>%1 items that are marked as not printable are left out</source>
        <translation>%1 éléments marqués comme non imprimables sont laissés de côté</translation>
    </message>
    <message>
        <source>%1 lines, points and faces with fewer than three corners are left out</source>
        <translation>%1 lignes, points et faces de moins de trois sommets sont laissés de côté</translation>
    </message>
    <message>
        <source>%1 modifiers, support blockers and the like are left out</source>
        <translation>%1 modificateurs, bloqueurs de supports et semblables sont laissés de côté</translation>
    </message>
    <message>
        <source>%1 objects of the type &apos;other&apos; are left out</source>
        <translation>%1 objets du type « other » sont laissés de côté</translation>
    </message>
    <message>
        <source>%1 shells inside others (%2 mm³, first around %3 mm) are turned outwards like them and count as solid material</source>
        <translation>%1 coques à l&apos;intérieur d&apos;autres (%2 mm³, d&apos;abord vers %3 mm) sont orientées vers l&apos;extérieur comme elles et comptent comme matière pleine</translation>
    </message>
    <message>
        <source>%1 shells inside others (%2 mm³, first around %3 mm) are turned outwards like them; paths fill them more than once</source>
        <translation>%1 coques à l&apos;intérieur d&apos;autres (%2 mm³, d&apos;abord vers %3 mm) sont orientées vers l&apos;extérieur comme elles ; les trajectoires les remplissent plusieurs fois</translation>
    </message>
    <message>
        <source>%1 supports are left out</source>
        <translation>%1 supports sont laissés de côté</translation>
    </message>
    <message>
        <source>%1 tessellated items that are no triangles are left out</source>
        <translation>%1 éléments tessellés qui ne sont pas des triangles sont laissés de côté</translation>
    </message>
    <message>
        <source>%1 texts of the STEP file are in an encoding that is not known; letters beyond ASCII in names are replaced</source>
        <translation>%1 textes du fichier STEP sont dans un codage inconnu ; les lettres hors ASCII des noms sont remplacées</translation>
    </message>
    <message>
        <source>%1 texts of the STEP file are not in an encoding of the standard; they were read as %2</source>
        <translation>%1 textes du fichier STEP ne sont pas dans un codage de la norme ; ils ont été lus comme %2</translation>
    </message>
    <message>
        <source>a comma outside of a function (position %1)</source>
        <translation>une virgule hors d&apos;une fonction (position %1)</translation>
    </message>
    <message>
        <source>a tag is longer than %1 bytes</source>
        <translation>une balise dépasse %1 octets</translation>
    </message>
    <message>
        <source>an assignment (position %1)</source>
        <translation>une affectation (position %1)</translation>
    </message>
    <message>
        <source>check the names of bodies, faces and edges</source>
        <translation>vérifiez les noms des corps, des faces et des arêtes</translation>
    </message>
    <message>
        <source>check this face in the CAD system, and export the part again</source>
        <translation>vérifiez cette face dans le logiciel de CAO et exportez à nouveau la pièce</translation>
    </message>
    <message>
        <source>cut it with the program that made it and export the result</source>
        <translation>faites la découpe avec le programme d&apos;origine et exportez le résultat</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>n&apos;existe pas</translation>
    </message>
    <message>
        <source>download the file itself, not the page that shows it</source>
        <translation>téléchargez le fichier lui-même, et non la page qui le montre</translation>
    </message>
    <message>
        <source>entity #%1 %2</source>
        <translation>l&apos;entité #%1 %2</translation>
    </message>
    <message>
        <source>export the assembly as one file</source>
        <translation>exportez l&apos;assemblage en un seul fichier</translation>
    </message>
    <message>
        <source>export the part as STEP, or as STL, OBJ, PLY or 3MF</source>
        <translation>exportez la pièce en STEP, ou en STL, OBJ, PLY ou 3MF</translation>
    </message>
    <message>
        <source>export the part as a mesh or as STEP</source>
        <translation>exportez la pièce en maillage ou en STEP</translation>
    </message>
    <message>
        <source>export the part as one file</source>
        <translation>exportez la pièce en un seul fichier</translation>
    </message>
    <message>
        <source>export the part with exact geometry, or as STL or 3MF</source>
        <translation>exportez la pièce avec une géométrie exacte, ou en STL ou 3MF</translation>
    </message>
    <message>
        <source>give them the type &apos;model&apos; if they are to be built</source>
        <translation>donnez-leur le type « model » s&apos;ils doivent être construits</translation>
    </message>
    <message>
        <source>has a coordinate of point %1 that is no number or too large</source>
        <translation>a une coordonnée du point %1 qui n&apos;est pas un nombre ou qui est trop grande</translation>
    </message>
    <message>
        <source>has a damaged list</source>
        <translation>a une liste endommagée</translation>
    </message>
    <message>
        <source>has a length unit that is not known</source>
        <translation>a une unité de longueur inconnue</translation>
    </message>
    <message>
        <source>has a point without three coordinates</source>
        <translation>a un point sans trois coordonnées</translation>
    </message>
    <message>
        <source>has a triangle without three corners</source>
        <translation>a un triangle sans trois sommets</translation>
    </message>
    <message>
        <source>has an index that is no positive whole number</source>
        <translation>a un indice qui n&apos;est pas un entier positif</translation>
    </message>
    <message>
        <source>has no context</source>
        <translation>n&apos;a pas de contexte</translation>
    </message>
    <message>
        <source>has no coordinates</source>
        <translation>n&apos;a pas de coordonnées</translation>
    </message>
    <message>
        <source>has no items</source>
        <translation>n&apos;a pas d&apos;éléments</translation>
    </message>
    <message>
        <source>has no list where one belongs</source>
        <translation>n&apos;a pas de liste là où il en faut une</translation>
    </message>
    <message>
        <source>has tessellated geometry that is placed apart (#%1), which is not read</source>
        <translation>a une géométrie tessellée placée à part (#%1), qui n&apos;est pas lue</translation>
    </message>
    <message>
        <source>has tessellated geometry, but no triangles that can be read</source>
        <translation>a une géométrie tessellée, mais aucun triangle lisible</translation>
    </message>
    <message>
        <source>has too few parameters</source>
        <translation>a trop peu de paramètres</translation>
    </message>
    <message>
        <source>is %1, not a part in the format %2</source>
        <translation>est %1, et non une pièce au format %2</translation>
    </message>
    <message>
        <source>is %1, not a part</source>
        <translation>est %1, et non une pièce</translation>
    </message>
    <message>
        <source>is a device or a pipe, not a file</source>
        <translation>est un périphérique ou un tube, et non un fichier</translation>
    </message>
    <message>
        <source>is a text that begins with %1 instead of &apos;solid&apos;</source>
        <translation>est un texte qui commence par %1 au lieu de « solid »</translation>
    </message>
    <message>
        <source>is an assembly of tessellated geometry, whose placements are not read</source>
        <translation>est un assemblage de géométrie tessellée, dont les placements ne sont pas lus</translation>
    </message>
    <message>
        <source>is an assembly whose parts stand in %1 other files, the first is &apos;%2&apos;</source>
        <translation>est un assemblage dont les pièces se trouvent dans %1 autres fichiers, le premier est « %2 »</translation>
    </message>
    <message>
        <source>is no 3MF model, its first element is %1</source>
        <translation>n&apos;est pas un modèle 3MF, son premier élément est %1</translation>
    </message>
    <message>
        <source>is no list of coordinates</source>
        <translation>n&apos;est pas une liste de coordonnées</translation>
    </message>
    <message>
        <source>is not a readable ZIP package: its directory is missing</source>
        <translation>n&apos;est pas une archive ZIP lisible : son répertoire manque</translation>
    </message>
    <message>
        <source>is one volume of a divided ZIP archive</source>
        <translation>est un volume d&apos;une archive ZIP divisée</translation>
    </message>
    <message>
        <source>its library cannot be loaded: it is not a file</source>
        <translation>sa bibliothèque ne peut pas être chargée : ce n&apos;est pas un fichier</translation>
    </message>
    <message>
        <source>make a surface of the points first</source>
        <translation>faites d&apos;abord une surface de ces points</translation>
    </message>
    <message>
        <source>mark them as printable in the program that made the file if they are wanted</source>
        <translation>marquez-les comme imprimables dans le programme d&apos;origine s&apos;ils sont voulus</translation>
    </message>
    <message>
        <source>name the file of the part</source>
        <translation>indiquez le fichier de la pièce</translation>
    </message>
    <message>
        <source>object &apos;%1&apos; has a coordinate that is too large: %2</source>
        <translation>l&apos;objet « %1 » a une coordonnée trop grande : %2</translation>
    </message>
    <message>
        <source>object &apos;%1&apos; is there twice</source>
        <translation>l&apos;objet « %1 » existe deux fois</translation>
    </message>
    <message>
        <source>part &apos;%1&apos; grows from %2 to %3 when it is unpacked; at most %4 times its size is taken</source>
        <translation>l&apos;élément « %1 » passe de %2 à %3 une fois décompressé ; au plus %4 fois sa taille est accepté</translation>
    </message>
    <message>
        <source>part &apos;%1&apos; is damaged: it cannot be unpacked beyond %2 bytes</source>
        <translation>l&apos;élément « %1 » est endommagé : il ne se décompresse pas au-delà de %2 octets</translation>
    </message>
    <message>
        <source>part &apos;%1&apos; is damaged: it has %2 bytes instead of %3</source>
        <translation>l&apos;élément « %1 » est endommagé : il a %2 octets au lieu de %3</translation>
    </message>
    <message>
        <source>part &apos;%1&apos; is damaged: it has more than the %2 bytes that the directory tells</source>
        <translation>l&apos;élément « %1 » est endommagé : il dépasse les %2 octets indiqués par le répertoire</translation>
    </message>
    <message>
        <source>part &apos;%1&apos; is damaged: its checksum is wrong</source>
        <translation>l&apos;élément « %1 » est endommagé : sa somme de contrôle est fausse</translation>
    </message>
    <message>
        <source>part &apos;%1&apos; is encrypted</source>
        <translation>l&apos;élément « %1 » est chiffré</translation>
    </message>
    <message>
        <source>part &apos;%1&apos; is packed by method %2; only deflate is known</source>
        <translation>l&apos;élément « %1 » est compressé par la méthode %2 ; seule deflate est connue</translation>
    </message>
    <message>
        <source>part &apos;%1&apos; is there twice</source>
        <translation>l&apos;élément « %1 » existe deux fois</translation>
    </message>
    <message>
        <source>refers to itself</source>
        <translation>se réfère à elle-même</translation>
    </message>
    <message>
        <source>refers to point %1, which does not exist</source>
        <translation>se réfère au point %1, qui n&apos;existe pas</translation>
    </message>
    <message>
        <source>save it as STL, OBJ, PLY or 3MF with the program that made it</source>
        <translation>enregistrez-le en STL, OBJ, PLY ou 3MF avec le programme d&apos;origine</translation>
    </message>
    <message>
        <source>save the content in a file first</source>
        <translation>enregistrez d&apos;abord le contenu dans un fichier</translation>
    </message>
    <message>
        <source>shapes of the 3MF extension &apos;%1&apos; are left out; only meshes are read</source>
        <translation>les formes de l&apos;extension 3MF « %1 » sont laissées de côté ; seuls les maillages sont lus</translation>
    </message>
    <message>
        <source>the STEP file has tessellated geometry only: its %1 triangles are read, and there are no exact surfaces</source>
        <translation>le fichier STEP n&apos;a qu&apos;une géométrie tessellée : ses %1 triangles sont lus, il n&apos;y a pas de surfaces exactes</translation>
    </message>
    <message>
        <source>the STEP file has tessellated shapes beside exact ones; the exact ones are read</source>
        <translation>le fichier STEP a des formes tessellées à côté de formes exactes ; les formes exactes sont lues</translation>
    </message>
    <message>
        <source>the ZIP archive has no 3MF model &apos;%1&apos;; its first file is &apos;%2&apos;</source>
        <translation>l&apos;archive ZIP n&apos;a pas de modèle 3MF « %1 » ; son premier fichier est « %2 »</translation>
    </message>
    <message>
        <source>the ZIP archive is cut off</source>
        <translation>l&apos;archive ZIP est tronquée</translation>
    </message>
    <message>
        <source>the directory of the ZIP archive is damaged</source>
        <translation>le répertoire de l&apos;archive ZIP est endommagé</translation>
    </message>
    <message>
        <source>the face refers to vertex %1; the file has %2</source>
        <translation>la face se réfère au sommet %1 ; le fichier en a %2</translation>
    </message>
    <message>
        <source>the file has no triangles; it is a point cloud of %1 points</source>
        <translation>le fichier n&apos;a pas de triangles ; c&apos;est un nuage de %1 points</translation>
    </message>
    <message>
        <source>the file is damaged or is not an STL file; export it again</source>
        <translation>le fichier est endommagé ou n&apos;est pas un fichier STL ; exportez-le à nouveau</translation>
    </message>
    <message>
        <source>the file is damaged; export it again</source>
        <translation>le fichier est endommagé ; exportez-le à nouveau</translation>
    </message>
    <message>
        <source>the file was made to fill the memory; do not use it</source>
        <translation>le fichier a été fait pour saturer la mémoire ; ne l&apos;utilisez pas</translation>
    </message>
    <message>
        <source>the file was not finished or is not an STL file; export it again</source>
        <translation>le fichier est inachevé ou n&apos;est pas un fichier STL ; exportez-le à nouveau</translation>
    </message>
    <message>
        <source>the header tells no triangles, but %1 bytes follow it</source>
        <translation>l&apos;en-tête n&apos;annonce aucun triangle, mais %1 octets le suivent</translation>
    </message>
    <message>
        <source>the model needs the 3MF extension &apos;%1&apos; (%2), which is not known</source>
        <translation>le modèle a besoin de l&apos;extension 3MF « %1 » (%2), qui est inconnue</translation>
    </message>
    <message>
        <source>the model needs the 3MF extension &apos;%1&apos;, which is not read</source>
        <translation>le modèle a besoin de l&apos;extension 3MF « %1 », qui n&apos;est pas lue</translation>
    </message>
    <message>
        <source>the negative volume &apos;%1&apos; cannot be cut out of &apos;%2&apos; and is left out; the part is solid there</source>
        <translation>le volume négatif « %1 » ne peut pas être soustrait de « %2 » et est laissé de côté ; la pièce y est pleine</translation>
    </message>
    <message>
        <source>the negative volume &apos;%1&apos; was cut out of the part</source>
        <translation>le volume négatif « %1 » a été soustrait de la pièce</translation>
    </message>
    <message>
        <source>the package builds %1 triangles; at most %2 are taken</source>
        <translation>le paquet construit %1 triangles ; au plus %2 sont acceptés</translation>
    </message>
    <message>
        <source>the package has no triangles to build</source>
        <translation>le paquet n&apos;a pas de triangles à construire</translation>
    </message>
    <message>
        <source>the package has no triangles, only beam lattices</source>
        <translation>le paquet n&apos;a pas de triangles, seulement des structures en treillis</translation>
    </message>
    <message>
        <source>the package has nothing to build: its items are marked as not printable</source>
        <translation>le paquet n&apos;a rien à construire : ses éléments sont marqués comme non imprimables</translation>
    </message>
    <message>
        <source>turn the beams into a mesh with the program that made the file</source>
        <translation>convertissez les poutres en maillage avec le programme d&apos;origine</translation>
    </message>
    <message>
        <source>turn the normals of a shell over if it is a cavity, else remove it</source>
        <translation>retournez les normales de la coque si c&apos;est une cavité, sinon supprimez-la</translation>
    </message>
    <message>
        <source>turn them into a mesh with the program that made the file</source>
        <translation>convertissez-les en maillage avec le programme d&apos;origine</translation>
    </message>
    <message>
        <source>unite the bodies in the CAD system</source>
        <translation>réunissez les corps dans le logiciel de CAO</translation>
    </message>
    <message>
        <source>unite the bodies in the CAD system, or move them apart</source>
        <translation>réunissez les corps dans le logiciel de CAO, ou écartez-les</translation>
    </message>
    <message>
        <source>unpack the archive and open the part in it</source>
        <translation>décompressez l&apos;archive et ouvrez la pièce qu&apos;elle contient</translation>
    </message>
    <message>
        <source>vertex %1 has a coordinate of %2, which is too large</source>
        <translation>le sommet %1 a une coordonnée de %2, ce qui est trop grand</translation>
    </message>
    <message>
        <source>write %1, with a decimal point</source>
        <translation>écrivez %1, avec un point décimal</translation>
    </message>
    <message>
        <source>write one formula, not a list</source>
        <translation>écrivez une seule formule, et non une liste</translation>
    </message>
    <message>
        <source>write the formula alone, without a name and &apos;=&apos;; &apos;==&apos; compares</source>
        <translation>écrivez la formule seule, sans nom ni « = » ; « == » compare</translation>
    </message>
    <message>
        <source>a 7-Zip archive</source>
        <translation>une archive 7-Zip</translation>
    </message>
    <message>
        <source>a Blender scene</source>
        <translation>une scène Blender</translation>
    </message>
    <message>
        <source>a CATIA document</source>
        <translation>un document CATIA</translation>
    </message>
    <message>
        <source>a COLLADA scene</source>
        <translation>une scène COLLADA</translation>
    </message>
    <message>
        <source>a Creo model</source>
        <translation>un modèle Creo</translation>
    </message>
    <message>
        <source>a DWG drawing</source>
        <translation>un dessin DWG</translation>
    </message>
    <message>
        <source>a DXF drawing</source>
        <translation>un dessin DXF</translation>
    </message>
    <message>
        <source>a GIF picture</source>
        <translation>une image GIF</translation>
    </message>
    <message>
        <source>a Gmsh mesh</source>
        <translation>un maillage Gmsh</translation>
    </message>
    <message>
        <source>a JPEG picture</source>
        <translation>une image JPEG</translation>
    </message>
    <message>
        <source>a JT model</source>
        <translation>un modèle JT</translation>
    </message>
    <message>
        <source>a LAS point cloud</source>
        <translation>un nuage de points LAS</translation>
    </message>
    <message>
        <source>a PCD point cloud</source>
        <translation>un nuage de points PCD</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>un document PDF</translation>
    </message>
    <message>
        <source>a PNG picture</source>
        <translation>une image PNG</translation>
    </message>
    <message>
        <source>a Parasolid model</source>
        <translation>un modèle Parasolid</translation>
    </message>
    <message>
        <source>a PostScript document</source>
        <translation>un document PostScript</translation>
    </message>
    <message>
        <source>a RAR archive</source>
        <translation>une archive RAR</translation>
    </message>
    <message>
        <source>a Rhino model</source>
        <translation>un modèle Rhino</translation>
    </message>
    <message>
        <source>a TIFF picture</source>
        <translation>une image TIFF</translation>
    </message>
    <message>
        <source>a VRML scene</source>
        <translation>une scène VRML</translation>
    </message>
    <message>
        <source>a VTK file</source>
        <translation>un fichier VTK</translation>
    </message>
    <message>
        <source>a Zstandard archive</source>
        <translation>une archive Zstandard</translation>
    </message>
    <message>
        <source>a bzip2 archive</source>
        <translation>une archive bzip2</translation>
    </message>
    <message>
        <source>a compound document (such as SolidWorks, Inventor or older Office files)</source>
        <translation>un document composite (comme les fichiers SolidWorks, Inventor ou d&apos;anciens fichiers Office)</translation>
    </message>
    <message>
        <source>a file of zeros only</source>
        <translation>un fichier qui ne contient que des zéros</translation>
    </message>
    <message>
        <source>a glTF scene</source>
        <translation>une scène glTF</translation>
    </message>
    <message>
        <source>a gzip archive</source>
        <translation>une archive gzip</translation>
    </message>
    <message>
        <source>a pointer of Git LFS</source>
        <translation>un pointeur Git LFS</translation>
    </message>
    <message>
        <source>a program</source>
        <translation>un programme</translation>
    </message>
    <message>
        <source>a program of Windows</source>
        <translation>un programme Windows</translation>
    </message>
    <message>
        <source>an ACIS model</source>
        <translation>un modèle ACIS</translation>
    </message>
    <message>
        <source>an AMF model</source>
        <translation>un modèle AMF</translation>
    </message>
    <message>
        <source>an E57 point cloud</source>
        <translation>un nuage de points E57</translation>
    </message>
    <message>
        <source>an FBX scene</source>
        <translation>une scène FBX</translation>
    </message>
    <message>
        <source>an HTML page</source>
        <translation>une page HTML</translation>
    </message>
    <message>
        <source>an OFF mesh</source>
        <translation>un maillage OFF</translation>
    </message>
    <message>
        <source>an RTF document</source>
        <translation>un document RTF</translation>
    </message>
    <message>
        <source>an SVG drawing</source>
        <translation>un dessin SVG</translation>
    </message>
    <message>
        <source>an X3D scene</source>
        <translation>une scène X3D</translation>
    </message>
    <message>
        <source>an XML document</source>
        <translation>un document XML</translation>
    </message>
    <message>
        <source>an xz archive</source>
        <translation>une archive xz</translation>
    </message>
    <message>
        <source>its content was lost; take another copy of it</source>
        <translation>son contenu est perdu ; prenez-en une autre copie</translation>
    </message>
    <message>
        <source>the model part of a 3MF package without its package</source>
        <translation>le modèle d&apos;un paquet 3MF sans son paquet</translation>
    </message>
    <message>
        <source>%1 point has a deposit height outside of its range; the worst is %2 mm where %3 to %4 mm are wanted</source>
        <translation>%1 point a une hauteur de dépôt hors de sa plage ; la pire est de %2 mm pour une plage de %3 à %4 mm</translation>
    </message>
    <message>
        <source>%1 point that should lie on the plate lies beside it, by %2 mm</source>
        <translation>%1 point qui devrait reposer sur la plaque se trouve à côté, de %2 mm</translation>
    </message>
    <message>
        <source>%1 points have a deposit height outside of their range; the worst is %2 mm where %3 to %4 mm are wanted</source>
        <translation>%1 points ont une hauteur de dépôt hors de leur plage ; la pire est de %2 mm pour une plage de %3 à %4 mm</translation>
    </message>
    <message>
        <source>%1 points of the spiral need a deposit outside of %2 to %3 mm; the worst is %4 mm</source>
        <translation>%1 points de la spirale demandent un dépôt hors de la plage de %2 à %3 mm ; le pire est de %4 mm</translation>
    </message>
    <message>
        <source>%1 points that should lie on the plate lie beside it, by up to %2 mm</source>
        <translation>%1 points qui devraient reposer sur la plaque se trouvent à côté, jusqu’à %2 mm</translation>
    </message>
    <message>
        <source>How far the tool axis may lean from the toolpath&apos;s. The mode planar_vertical leans it until it is vertical; more than this is a violation.</source>
        <translation>Inclinaison maximale de l’axe de l’outil par rapport à celui de la trajectoire. Le mode planar_vertical l’incline jusqu’à la verticale ; au-delà de cette valeur, c’est une non-conformité.</translation>
    </message>
    <message>
        <source>J4 + J6 where the cable is not twisted; counts with a cable_limit of its own.</source>
        <translation>J4 + J6 quand le câble n’est pas vrillé ; s’applique avec un cable_limit propre.</translation>
    </message>
    <message>
        <source>Maximum distance between the path and the curve it follows. 0 follows from part and bead: 0.01 mm on CAD surfaces; on a mesh as much as the mesh itself deviates from its shape, but no more than 2 % of the bead&apos;s width.</source>
        <translation>Écart maximal entre la trajectoire et la courbe qu’elle suit. 0 : déduit de la pièce et du cordon, soit 0,01 mm sur des surfaces CAO ; sur un maillage, autant que le maillage s’écarte de sa forme, sans dépasser 2 % de la largeur du cordon.</translation>
    </message>
    <message>
        <source>Minimum speed</source>
        <translation>Vitesse minimale</translation>
    </message>
    <message>
        <source>Minimum wire feed speed</source>
        <translation>Vitesse de fil minimale</translation>
    </message>
    <message>
        <source>Part of the wanted speed below which the torch must not fall with the arc on, as a mean over a bead&apos;s width: what passes within that, as the slow-down at ends and corners, melts into one pool. Below is a violation.</source>
        <translation>Part de la vitesse voulue sous laquelle la torche ne doit pas descendre arc allumé, en moyenne sur une largeur de cordon : les ralentissements plus courts, aux extrémités et aux angles, se fondent dans le même bain. En dessous, c’est une non-conformité.</translation>
    </message>
    <message>
        <source>Robots leave the line between far points; 4.9 mm keeps them on it. 0 takes these 4.9 mm, or the bead&apos;s width if it is narrower.</source>
        <translation>Entre des points éloignés, les robots s’écartent de la ligne ; 4,9 mm les y maintient. 0 prend ces 4,9 mm, ou la largeur du cordon si elle est plus petite.</translation>
    </message>
    <message>
        <source>belongs to a torch that the robot carries</source>
        <translation>ne s’applique qu’à une torche portée par le robot</translation>
    </message>
    <message>
        <source>move part and substrate onto the table, or describe what carries them in the cell file (positioner, collision, frame table)</source>
        <translation>placez la pièce et le substrat sur la table, ou décrivez ce qui les porte dans le fichier de cellule (positioner, collision, repère table)</translation>
    </message>
    <message>
        <source>put the bead on the centre of the contour, or change the height of the part&apos;s upper edge by as much</source>
        <translation>centrez le cordon sur le contour, ou modifiez d’autant la hauteur du bord supérieur de la pièce</translation>
    </message>
    <message>
        <source>set wire_speed to %1 m/min, with the job of the welding source for it</source>
        <translation>réglez wire_speed à %1 m/min, avec le programme correspondant de la source de soudage</translation>
    </message>
    <message>
        <source>the beads hold %1 % of the volume of the layer and pile up</source>
        <translation>les cordons contiennent %1 % du volume de la couche et s’accumulent</translation>
    </message>
    <message>
        <source>the last layer lies up to %1 mm higher than the part: the wall leans, and its beads lie beside it</source>
        <translation>la dernière couche dépasse la pièce de %1 mm au plus : la paroi est inclinée et ses cordons sont à côté</translation>
    </message>
    <message>
        <source>the last layer lies up to %1 mm lower than the part: the wall leans, and its beads lie beside it</source>
        <translation>la dernière couche reste jusqu’à %1 mm sous le sommet de la pièce : la paroi est inclinée et ses cordons sont à côté</translation>
    </message>
    <message>
        <source>the substrate lies beside the table that carries it, by %1 mm</source>
        <translation>le substrat se trouve à %1 mm à côté de la table qui le porte</translation>
    </message>
    <message>
        <source>the torch needs %1 s for %2 mm with the arc on, %3 mm/s or %4 % of the wanted speed, and %5 mm/s at the slowest point</source>
        <translation>la torche met %1 s pour %2 mm arc allumé, soit %3 mm/s ou %4 % de la vitesse voulue, et %5 mm/s au point le plus lent</translation>
    </message>
    <message>
        <source>the torch needs %1 s for %2 mm with the arc on, %3 mm/s or %4 % of the wanted speed, and %5 mm/s at the slowest point; nearest to its limit is joint %6</source>
        <translation>la torche met %1 s pour %2 mm arc allumé, soit %3 mm/s ou %4 % de la vitesse voulue, et %5 mm/s au point le plus lent ; l’axe le plus proche de sa limite est %6</translation>
    </message>
    <message>
        <source>use the mode optimized, smooth the path (axis_rate bounds the turn of its build direction), raise vertical_tolerance or lower the travel speed; lower min_speed_ratio only where the process bears it</source>
        <translation>utilisez le mode optimized, lissez la trajectoire (axis_rate borne la rotation de sa direction de construction), augmentez vertical_tolerance ou réduisez la vitesse d’avance ; ne baissez min_speed_ratio que si le procédé le permet</translation>
    </message>
    <message>
        <source>Mean of (1 - predicted over wanted speed) squared, by the prediction of time and speed.</source>
        <translation>Moyenne de (1 - vitesse prévue / vitesse voulue) au carré, d’après la prévision du temps et de la vitesse.</translation>
    </message>
    <message>
        <source>%1 belongs to another user, who could change it</source>
        <translation>%1 appartient à un autre utilisateur, qui pourrait le modifier</translation>
    </message>
    <message>
        <source>another group can write %1; take that right away (chmod g-w)</source>
        <translation>un autre groupe peut écrire dans %1 ; retirez ce droit (chmod g-w)</translation>
    </message>
    <message>
        <source>everybody can write %1; take that right away (chmod o-w)</source>
        <translation>tout le monde peut écrire dans %1 ; retirez ce droit (chmod o-w)</translation>
    </message>
    <message>
        <source>it is a link out of its folder, to %1</source>
        <translation>c&apos;est un lien hors de son dossier, vers %1</translation>
    </message>
    <message>
        <source>it would take the place of the installed plugin %1; name it with --plugin to use it</source>
        <translation>il prendrait la place du plugin installé %1 ; nommez-le avec --plugin pour l&apos;utiliser</translation>
    </message>
    <message>
        <source>its component &apos;%1&apos; would take the place of that of the installed plugin %2; name it with --plugin to use it</source>
        <translation>son composant « %1 » prendrait la place de celui du plugin installé %2 ; nommez-le avec --plugin pour l&apos;utiliser</translation>
    </message>
    <message>
        <source>its library is not loaded: %1</source>
        <translation>sa bibliothèque n&apos;est pas chargée : %1</translation>
    </message>
    <message>
        <source>its maker is the owner of %1; %2</source>
        <translation>son auteur est le propriétaire de %1 ; %2</translation>
    </message>
    <message>
        <source>loading it crashes (signal %1)</source>
        <translation>son chargement provoque un plantage (signal %1)</translation>
    </message>
    <message>
        <source>loading it does not come to an end within %1 s</source>
        <translation>son chargement ne se termine pas en %1 s</translation>
    </message>
    <message>
        <source>loading it ends the program (exit code %1)</source>
        <translation>son chargement termine le programme (code de sortie %1)</translation>
    </message>
    <message>
        <source>output file &apos;%1&apos; has a value that is no number (nan or inf) in line %2</source>
        <translation>le fichier de sortie « %1 » contient une valeur qui n&apos;est pas un nombre (nan ou inf) à la ligne %2</translation>
    </message>
    <message>
        <source>output file &apos;%1&apos; is empty</source>
        <translation>le fichier de sortie « %1 » est vide</translation>
    </message>
    <message>
        <source>report this to the vendor of the plugin: a program belongs in the files that it returns</source>
        <translation>signalez-le à l&apos;auteur du plugin : un programme doit être dans les fichiers qu&apos;il renvoie</translation>
    </message>
    <message>
        <source>the folder depends on where the program is started; name its whole path</source>
        <translation>le dossier dépend de l&apos;endroit où le programme est lancé ; donnez son chemin complet</translation>
    </message>
    <message>
        <source>writes to standard output, beginning with &apos;%1&apos;</source>
        <translation>écrit sur la sortie standard, à commencer par « %1 »</translation>
    </message>
    <message>
        <source>%1 beam lattice is left out (beams: %2)</source>
        <translation>%1 treillis de poutres est ignoré (poutres : %2)</translation>
    </message>
    <message>
        <source>%1 beam lattices are left out (beams: %2)</source>
        <translation>%1 treillis de poutres sont ignorés (poutres : %2)</translation>
    </message>
    <message>
        <source>%1 call of another file in the OBJ file is not followed</source>
        <translation>%1 appel d&apos;un autre fichier dans le fichier OBJ n&apos;est pas suivi</translation>
    </message>
    <message>
        <source>%1 free-form curve or surface of the OBJ file is left out</source>
        <translation>%1 courbe ou surface de forme libre du fichier OBJ est ignorée</translation>
    </message>
    <message>
        <source>%1 item that is marked as not printable is left out</source>
        <translation>%1 élément marqué comme non imprimable est ignoré</translation>
    </message>
    <message>
        <source>%1 line, point or face with fewer than three corners is left out</source>
        <translation>%1 ligne, point ou face de moins de trois sommets est ignoré</translation>
    </message>
    <message>
        <source>%1 modifier, support blocker or the like is left out</source>
        <translation>%1 modificateur, bloqueur de supports ou similaire est ignoré</translation>
    </message>
    <message>
        <source>%1 object of the type &apos;other&apos; is left out</source>
        <translation>%1 objet de type « other » est ignoré</translation>
    </message>
    <message>
        <source>%1 support is left out</source>
        <translation>%1 support est ignoré</translation>
    </message>
    <message>
        <source>a RIFF file (a WebP picture, a sound or a film)</source>
        <translation>un fichier RIFF (image WebP, son ou film)</translation>
    </message>
    <message>
        <source>export fewer copies</source>
        <translation>exportez moins de copies</translation>
    </message>
    <message>
        <source>export fewer copies, or a coarser mesh</source>
        <translation>exportez moins de copies ou un maillage plus grossier</translation>
    </message>
    <message>
        <source>export it without this extension</source>
        <translation>exportez-le sans cette extension</translation>
    </message>
    <message>
        <source>export the part as a mesh of triangles</source>
        <translation>exportez la pièce comme un maillage de triangles</translation>
    </message>
    <message>
        <source>join the volumes and open the whole archive</source>
        <translation>réunissez les volumes et ouvrez l&apos;archive complète</translation>
    </message>
    <message>
        <source>pack it with deflate, or export it again</source>
        <translation>compressez-la avec deflate ou exportez-la à nouveau</translation>
    </message>
    <message>
        <source>put a part on the build plate in the program that made the file</source>
        <translation>placez une pièce sur le plateau dans le logiciel d&apos;origine</translation>
    </message>
    <message>
        <source>save the package without a password</source>
        <translation>enregistrez le paquet sans mot de passe</translation>
    </message>
    <message>
        <source>%1 %4 is not within %2 and %3 %4</source>
        <translation>%1 %4 n’est pas compris entre %2 et %3 %4</translation>
    </message>
    <message>
        <source>%1 is not within %2 and %3</source>
        <translation>%1 n’est pas compris entre %2 et %3</translation>
    </message>
    <message>
        <source>%1; the budget is %2</source>
        <translation>%1 ; le budget est de %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no item of the budget</source>
        <translation>« %1 » n’est pas un élément du budget</translation>
    </message>
    <message>
        <source>budget</source>
        <translation>budget</translation>
    </message>
    <message>
        <source>change the formula or its range: a guide is one smooth curve</source>
        <translation>modifiez la formule ou son intervalle : un guide est une seule courbe lisse</translation>
    </message>
    <message>
        <source>check the unit and the placement, and export the part again</source>
        <translation>vérifiez l’unité et le placement, puis exportez la pièce à nouveau</translation>
    </message>
    <message>
        <source>column %1: %2</source>
        <translation>colonne %1 : %2</translation>
    </message>
    <message>
        <source>correct the point</source>
        <translation>corrigez le point</translation>
    </message>
    <message>
        <source>correct the row, or its unit</source>
        <translation>corrigez la ligne ou son unité</translation>
    </message>
    <message>
        <source>face %1, coordinate: %2</source>
        <translation>face %1, coordonnée : %2</translation>
    </message>
    <message>
        <source>guide &apos;%1&apos;, %2</source>
        <translation>guide « %1 », %2</translation>
    </message>
    <message>
        <source>line %1: decimal commas</source>
        <translation>ligne %1 : virgules décimales</translation>
    </message>
    <message>
        <source>make it less, or raise the budget: WCAM_BUDGET=%1=%2</source>
        <translation>réduisez-le ou augmentez le budget : WCAM_BUDGET=%1=%2</translation>
    </message>
    <message>
        <source>move one of them, or take it out of the operation</source>
        <translation>déplacez l’une d’elles ou retirez-la de l’opération</translation>
    </message>
    <message>
        <source>parts</source>
        <translation>pièces</translation>
    </message>
    <message>
        <source>point %1 repeats the one before it</source>
        <translation>le point %1 répète le précédent</translation>
    </message>
    <message>
        <source>point %1: %2</source>
        <translation>point %1 : %2</translation>
    </message>
    <message>
        <source>shorten the guide or raise the step</source>
        <translation>raccourcissez le guide ou augmentez le pas</translation>
    </message>
    <message>
        <source>the file has %1 MiB</source>
        <translation>le fichier fait %1 Mio</translation>
    </message>
    <message>
        <source>the file holds too many values</source>
        <translation>le fichier contient trop de valeurs</translation>
    </message>
    <message>
        <source>the formula jumps by %1 mm at t = %2</source>
        <translation>la formule saute de %1 mm à t = %2</translation>
    </message>
    <message>
        <source>the guide has more than %1 layers of %2 mm</source>
        <translation>le guide compte plus de %1 couches de %2 mm</translation>
    </message>
    <message>
        <source>the guide leaves its range at t = %1: %2</source>
        <translation>le guide sort de son domaine à t = %1 : %2</translation>
    </message>
    <message>
        <source>the operation has %1 layers</source>
        <translation>l’opération compte %1 couches</translation>
    </message>
    <message>
        <source>the operation has %1 parts</source>
        <translation>l’opération compte %1 pièces</translation>
    </message>
    <message>
        <source>the parts &apos;%1&apos; and &apos;%2&apos; are equal and stand in one place</source>
        <translation>les pièces « %1 » et « %2 » sont identiques et occupent la même place</translation>
    </message>
    <message>
        <source>the path has %1 points</source>
        <translation>la trajectoire compte %1 points</translation>
    </message>
    <message>
        <source>the run needs more than the %1 MiB of memory that it may take</source>
        <translation>l’exécution demande plus que les %1 Mio de mémoire autorisés</translation>
    </message>
    <message>
        <source>use a coarser part, step or spacing; with more memory in the machine, raise memory_mb in WCAM_BUDGET</source>
        <translation>prenez une pièce, un pas ou un espacement plus grossier ; si la machine a plus de mémoire, augmentez memory_mb dans WCAM_BUDGET</translation>
    </message>
    <message>
        <source>vertex %1, coordinate: %2</source>
        <translation>sommet %1, coordonnée : %2</translation>
    </message>
    <message>
        <source>write KEY=N with a whole number above 0; keys: %1</source>
        <translation>écrivez CLÉ=N avec un entier supérieur à 0 ; clés : %1</translation>
    </message>
    <message>
        <source>write decimal points, and x y z in mm, one point per line</source>
        <translation>écrivez des points décimaux, et x y z en mm, un point par ligne</translation>
    </message>
    <message>
        <source>%1 lines</source>
        <translation>%1 lignes</translation>
    </message>
    <message>
        <source>%1 positions</source>
        <translation>%1 positions</translation>
    </message>
    <message>
        <source>%1 positions and %2 lines</source>
        <translation>%1 positions et %2 lignes</translation>
    </message>
    <message>
        <source>%1 triangles back to back between touching bodies were dropped, the first at %2 mm: the bodies are built as one</source>
        <translation>%1 triangles dos à dos entre des corps qui se touchent ont été supprimés, le premier en %2 mm : les corps sont construits comme un seul</translation>
    </message>
    <message>
        <source>a bead is longer than one program of at most %1: it would be cut with the arc on, into parts that cannot be started alone</source>
        <translation>un cordon est plus long qu&apos;un programme d&apos;au plus %1 : il serait coupé avec l&apos;arc allumé, en parties qui ne peuvent pas démarrer seules</translation>
    </message>
    <message>
        <source>a program of at most %1 has no room for a move</source>
        <translation>un programme d&apos;au plus %1 n&apos;a pas la place d&apos;un mouvement</translation>
    </message>
    <message>
        <source>%1 would replace %2</source>
        <translation>%1 remplacerait %2</translation>
    </message>
    <message>
        <source>a run was interrupted while its files took their places in %1</source>
        <translation>une exécution a été interrompue pendant que ses fichiers prenaient leur place dans %1</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>un autre programme</translation>
    </message>
    <message>
        <source>another program has changed or removed the file since it was read</source>
        <translation>un autre programme a modifié ou supprimé le fichier depuis sa lecture</translation>
    </message>
    <message>
        <source>another program has the project open (%1)</source>
        <translation>un autre programme a le projet ouvert (%1)</translation>
    </message>
    <message>
        <source>another program is changing the project (%1)</source>
        <translation>un autre programme modifie le projet (%1)</translation>
    </message>
    <message>
        <source>another run is writing to the folder</source>
        <translation>une autre exécution écrit dans le dossier</translation>
    </message>
    <message>
        <source>cannot be changed, since its lock file cannot be made: %1</source>
        <translation>ne peut pas être modifié, car son fichier de verrou ne peut pas être créé : %1</translation>
    </message>
    <message>
        <source>cannot be replaced: %1; the folder holds files of two runs</source>
        <translation>ne peut pas être remplacé : %1 ; le dossier contient les fichiers de deux exécutions</translation>
    </message>
    <message>
        <source>choose another name or folder</source>
        <translation>choisissez un autre nom ou dossier</translation>
    </message>
    <message>
        <source>close it there and try again</source>
        <translation>fermez-le là-bas et réessayez</translation>
    </message>
    <message>
        <source>export the project again when the programs are to be those of this version</source>
        <translation>exportez à nouveau le projet si les programmes doivent être ceux de cette version</translation>
    </message>
    <message>
        <source>export the project again, or check with the same --set</source>
        <translation>exportez à nouveau le projet ou vérifiez avec les mêmes --set</translation>
    </message>
    <message>
        <source>give one of them another name or folder</source>
        <translation>donnez à l&apos;un d&apos;eux un autre nom ou dossier</translation>
    </message>
    <message>
        <source>install a plugin that fits, or see `camcli plugins list`</source>
        <translation>installez un plugin compatible ou voyez `camcli plugins list`</translation>
    </message>
    <message>
        <source>is a link, and links within an output folder are not followed</source>
        <translation>est un lien, et les liens dans un dossier de sortie ne sont pas suivis</translation>
    </message>
    <message>
        <source>is a part, not a project</source>
        <translation>est une pièce, pas un projet</translation>
    </message>
    <message>
        <source>is not a regular file and is not replaced</source>
        <translation>n&apos;est pas un fichier ordinaire et n&apos;est pas remplacé</translation>
    </message>
    <message>
        <source>is not a report of this version of WCAM, which names files with their hashes</source>
        <translation>n&apos;est pas un rapport de cette version de WCAM, qui nomme les fichiers avec leurs empreintes</translation>
    </message>
    <message>
        <source>is read-only and is not replaced</source>
        <translation>est en lecture seule et n&apos;est pas remplacé</translation>
    </message>
    <message>
        <source>make a project of it: camcli new %1.wcam --part %2</source>
        <translation>faites-en un projet : camcli new %1.wcam --part %2</translation>
    </message>
    <message>
        <source>make it writable, or choose another name</source>
        <translation>rendez-le modifiable ou choisissez un autre nom</translation>
    </message>
    <message>
        <source>make it writable, or choose another output folder</source>
        <translation>rendez-le modifiable ou choisissez un autre dossier de sortie</translation>
    </message>
    <message>
        <source>make the file and its folder writable and export again</source>
        <translation>rendez le fichier et son dossier modifiables et exportez à nouveau</translation>
    </message>
    <message>
        <source>move it elsewhere when it is the program of an earlier run</source>
        <translation>déplacez-le s&apos;il s&apos;agit du programme d&apos;une exécution précédente</translation>
    </message>
    <message>
        <source>name a folder below it, or allow it with --allow-outside</source>
        <translation>indiquez un dossier à l&apos;intérieur ou autorisez-le avec --allow-outside</translation>
    </message>
    <message>
        <source>process %1 on %2</source>
        <translation>processus %1 sur %2</translation>
    </message>
    <message>
        <source>put right what the report names and export the project again</source>
        <translation>corrigez ce que le rapport indique et exportez à nouveau le projet</translation>
    </message>
    <message>
        <source>read it again, or save under another name</source>
        <translation>relisez-le ou enregistrez sous un autre nom</translation>
    </message>
    <message>
        <source>remove it, or choose another output folder</source>
        <translation>supprimez-le ou choisissez un autre dossier de sortie</translation>
    </message>
    <message>
        <source>remove the link, or choose another output folder</source>
        <translation>supprimez le lien ou choisissez un autre dossier de sortie</translation>
    </message>
    <message>
        <source>the file %1 is not of the run that the report describes</source>
        <translation>le fichier %1 ne vient pas de l&apos;exécution que décrit le rapport</translation>
    </message>
    <message>
        <source>the file %1 is not the one that the report was written with</source>
        <translation>le fichier %1 n&apos;est pas celui avec lequel le rapport a été écrit</translation>
    </message>
    <message>
        <source>the file %1 of the report is missing</source>
        <translation>le fichier %1 du rapport manque</translation>
    </message>
    <message>
        <source>the file of the %1</source>
        <translation>le fichier de : %1</translation>
    </message>
    <message>
        <source>the folder &apos;%1&apos; of output &apos;%2&apos; lies outside of the output folder</source>
        <translation>le dossier « %1 » de la sortie « %2 » est en dehors du dossier de sortie</translation>
    </message>
    <message>
        <source>the input &apos;%1&apos; is not the one that the programs were made from</source>
        <translation>l&apos;entrée « %1 » n&apos;est pas celle dont les programmes ont été faits</translation>
    </message>
    <message>
        <source>the plugin &apos;%1&apos; is not the one that made the programs</source>
        <translation>le plugin « %1 » n&apos;est pas celui qui a fait les programmes</translation>
    </message>
    <message>
        <source>the programs were made by WCAM %1, this is %2</source>
        <translation>les programmes ont été faits par WCAM %1, ceci est %2</translation>
    </message>
    <message>
        <source>the programs were made with other settings: %1</source>
        <translation>les programmes ont été faits avec d&apos;autres réglages : %1</translation>
    </message>
    <message>
        <source>the project</source>
        <translation>le projet</translation>
    </message>
    <message>
        <source>the project has changed since the programs were made</source>
        <translation>le projet a changé depuis que les programmes ont été faits</translation>
    </message>
    <message>
        <source>the report of the output folder</source>
        <translation>le rapport du dossier de sortie</translation>
    </message>
    <message>
        <source>the run gave no program for some operations or outputs, as its report says</source>
        <translation>l&apos;exécution n&apos;a pas donné de programme pour certaines opérations ou sorties, comme le dit son rapport</translation>
    </message>
    <message>
        <source>wait until it has ended, or choose another output folder</source>
        <translation>attendez qu&apos;elle soit terminée ou choisissez un autre dossier de sortie</translation>
    </message>
    <message>
        <source>axis J%1 is %2 turns from its zero; the turn numbers of a position go from -8 to 7</source>
        <translation>l&apos;axe J%1 est à %2 tours de son zéro ; les numéros de tour d&apos;une position vont de -8 à 7</translation>
    </message>
    <message>
        <source>split the operation so that the axis turns back between its parts, or let beads change their direction (alternate)</source>
        <translation>partagez l&apos;opération pour que l&apos;axe se déroule entre ses parties, ou faites alterner le sens des cordons (alternate)</translation>
    </message>
    <message>
        <source>beads lie up to %1 mm inside the plate, deepest at (%2, %3, %4)</source>
        <translation>des cordons se trouvent jusqu&apos;à %1 mm dans la plaque, au plus profond en (%2, %3, %4)</translation>
    </message>
    <message>
        <source>%1 contours of the layer at %2 are single points and were dropped, the first at %3</source>
        <translation>%1 contours de la couche à %2 sont de simples points et ont été écartés, le premier à %3</translation>
    </message>
    <message>
        <source>%1 mm² of part %2 lie too far from every bead and are not covered</source>
        <translation>%1 mm² de la pièce %2 sont trop loin de tout cordon et ne sont pas recouverts</translation>
    </message>
    <message>
        <source>%1, or choose a strategy whose layers begin at the plate</source>
        <translation>%1, ou choisissez une stratégie dont les couches commencent à la plaque</translation>
    </message>
    <message>
        <source>%1, so that it stands on the plate</source>
        <translation>%1, pour qu’elle repose sur la plaque</translation>
    </message>
    <message>
        <source>Measured on the surface; 0.667 leaves a level surface (Ding 2015). It is changed a little, so that beads end at both borders.</source>
        <translation>Mesuré sur la surface ; 0.667 laisse une surface plane (Ding 2015). Elle est un peu ajustée pour que les cordons arrivent aux deux bords.</translation>
    </message>
    <message>
        <source>What lies on the border: the bead&apos;s side or its centre. A centre on the border adds half a bead distance of stock beyond it.</source>
        <translation>Ce qui se trouve sur le bord : le côté du cordon ou son axe. L’axe sur le bord ajoute au-delà une surépaisseur d’un demi-entraxe de cordons.</translation>
    </message>
    <message>
        <source>Where even the maximum travel speed deposits too much, as in thin layers or in beads side by side, the wire feed of the whole operation is lowered, but not below this value. Set it to the wire feed speed to keep the feed as it is.</source>
        <translation>Si même la vitesse d’avance maximale dépose trop de matière, comme dans des couches minces ou des cordons côte à côte, la vitesse de fil de toute l’opération est réduite, sans descendre sous cette valeur. Donnez-lui la vitesse de fil pour ne rien changer.</translation>
    </message>
    <message>
        <source>a comma between two digits (position %1) may be a decimal comma or separate two values</source>
        <translation>une virgule entre deux chiffres (position %1) peut être une virgule décimale ou séparer deux valeurs</translation>
    </message>
    <message>
        <source>a contour of the layer at %1 is a single point and was dropped, at %2</source>
        <translation>un contour de la couche à %1 est un simple point et a été écarté, en %2</translation>
    </message>
    <message>
        <source>a smaller step, a narrower bead or a smaller maximum width (max_width) covers more</source>
        <translation>un pas plus petit, un cordon plus étroit ou une largeur maximale plus petite (max_width) recouvre davantage</translation>
    </message>
    <message>
        <source>at the maximum travel speed of %1 mm/s the wire feed of %2 m/min would deposit too much, and %3 m/min is used</source>
        <translation>à la vitesse d’avance maximale de %1 mm/s, la vitesse de fil de %2 m/min déposerait trop de matière ; %3 m/min est utilisée</translation>
    </message>
    <message>
        <source>choose a pattern that fills the inside (pattern), or more walls</source>
        <translation>choisissez un motif qui remplit l’intérieur (pattern), ou davantage de parois</translation>
    </message>
    <message>
        <source>choose a pattern that fills the inside, or another bead width</source>
        <translation>choisissez un motif qui remplit l’intérieur, ou une autre largeur de cordon</translation>
    </message>
    <message>
        <source>choose a plate of %1 by %2 mm or more, and place the part on it</source>
        <translation>choisissez une plaque d’au moins %1 sur %2 mm et placez-y la pièce</translation>
    </message>
    <message>
        <source>export the part with finer facets if its end is round; otherwise shape it by an operation of its own</source>
        <translation>exportez la pièce avec des facettes plus fines si son extrémité est ronde ; sinon, faites-la par une opération à part</translation>
    </message>
    <message>
        <source>look for a division by zero or the root of a negative number, and change the formula or its range</source>
        <translation>cherchez une division par zéro ou la racine d’un nombre négatif, et changez la formule ou son intervalle</translation>
    </message>
    <message>
        <source>lower the part by %1 mm</source>
        <translation>abaissez la pièce de %1 mm</translation>
    </message>
    <message>
        <source>move the part by (%1, %2, %3) mm, along the plate&apos;s normal</source>
        <translation>déplacez la pièce de (%1, %2, %3) mm, selon la normale de la plaque</translation>
    </message>
    <message>
        <source>move the part by (%1, %2, %3) mm, or choose a larger plate</source>
        <translation>déplacez la pièce de (%1, %2, %3) mm, ou choisissez une plaque plus grande</translation>
    </message>
    <message>
        <source>must begin where the piece before it ends, and not %1 mm from there</source>
        <translation>doit commencer là où finit le morceau précédent, et non à %1 mm de là</translation>
    </message>
    <message>
        <source>only a modulation range of %1 holds these heights, but %2 points instead of %3 would then leave the layer heights of the process: another decomposition or planar layers may suit this end better</source>
        <translation>seule une plage de modulation de %1 contient ces hauteurs, mais %2 points au lieu de %3 sortiraient alors des hauteurs de couche du procédé : une autre décomposition ou des couches planes conviendraient peut-être mieux à cette extrémité</translation>
    </message>
    <message>
        <source>part %1 floats %2 mm above the plate; its first layer fills what is between</source>
        <translation>la pièce %1 flotte à %2 mm au-dessus de la plaque ; sa première couche remplit l’intervalle</translation>
    </message>
    <message>
        <source>raise the part by %1 mm</source>
        <translation>relevez la pièce de %1 mm</translation>
    </message>
    <message>
        <source>set bead_width to %1 mm: %2 % of the volume are then filled (this was tried)</source>
        <translation>mettez bead_width à %1 mm : %2 % du volume sont alors remplis (essayé)</translation>
    </message>
    <message>
        <source>set max_width to %1 mm: %2 % of the volume are then filled (this was tried)</source>
        <translation>mettez max_width à %1 mm : %2 % du volume sont alors remplis (essayé)</translation>
    </message>
    <message>
        <source>set pattern to %1: %2 % of the volume are then filled (this was tried)</source>
        <translation>mettez pattern à %1 : %2 % du volume sont alors remplis (essayé)</translation>
    </message>
    <message>
        <source>the beads hold %1 % of the volume of the layer: they do not reach all of the section</source>
        <translation>les cordons contiennent %1 % du volume de la couche : ils n’atteignent pas toute la section</translation>
    </message>
    <message>
        <source>the end of part %1 is made of flats: it goes on above the last layer for %2 mm at its corners and for %3 mm between them</source>
        <translation>l’extrémité de la pièce %1 est faite de plats : elle dépasse la dernière couche de %2 mm à ses coins et de %3 mm entre eux</translation>
    </message>
    <message>
        <source>the formula has no value at z = %1</source>
        <translation>la formule n’a pas de valeur en z = %1</translation>
    </message>
    <message>
        <source>use another pattern, fewer walls or a narrower bead</source>
        <translation>prenez un autre motif, moins de parois ou un cordon plus étroit</translation>
    </message>
    <message>
        <source>use narrower beads, allow shorter ones (min_length), or take another pattern or direction</source>
        <translation>prenez des cordons plus étroits, permettez-en de plus courts (min_length), ou changez de motif ou de direction</translation>
    </message>
    <message>
        <source>write %1, with a decimal point, or %2, with a blank after the comma</source>
        <translation>écrivez %1, avec un point décimal, ou %2, avec une espace après la virgule</translation>
    </message>
    <message>
        <source>&apos;%1&apos; becomes %2: names of programs have letters from A to Z, digits and _, begin with a letter and have at most %3 characters</source>
        <translation>« %1 » devient %2 : les noms de programmes ont des lettres de A à Z, des chiffres et _, commencent par une lettre et ont au plus %3 caractères</translation>
    </message>
    <message>
        <source>Of |J4 + J6|, from the untwisted cable&apos;s value; more is a violation. 0 takes the limit and the zero of the cell file, if it has them. 120 deg is usual for torch cables (Chalvin A33); a large value lifts the limit.</source>
        <translation>De |J4 + J6|, à partir de la valeur du câble non tordu ; au-delà, c&apos;est une violation. 0 prend la limite et le zéro du fichier de cellule, s&apos;il en a. 120 deg est usuel pour les câbles de torche (Chalvin A33) ; une grande valeur lève la limite.</translation>
    </message>
    <message>
        <source>beads are laid up to %1 inside %2, at %3</source>
        <translation>des cordons sont déposés jusqu&apos;à %1 à l&apos;intérieur de %2, sur %3</translation>
    </message>
    <message>
        <source>cabinet</source>
        <translation>armoire</translation>
    </message>
    <message>
        <source>cable envelope</source>
        <translation>enveloppe des câbles</translation>
    </message>
    <message>
        <source>change the rotation about the torch or the configuration, or raise cable_limit if the cable bears it; check the cable&apos;s zero</source>
        <translation>changer la rotation autour de la torche ou la configuration, ou augmenter cable_limit si le câble le supporte ; vérifier le zéro du câble</translation>
    </message>
    <message>
        <source>clamp</source>
        <translation>bride</translation>
    </message>
    <message>
        <source>column</source>
        <translation>colonne</translation>
    </message>
    <message>
        <source>component &apos;%1&apos; cannot be used: %2</source>
        <translation>le composant « %1 » ne peut pas être utilisé : %2</translation>
    </message>
    <message>
        <source>correct the file at this place: in JSON numbers are finite and have a decimal point, texts stand in double quotes, and every key stands once in its object</source>
        <translation>corriger le fichier à cet endroit : en JSON les nombres sont finis et ont un point décimal, les textes sont entre guillemets doubles et chaque clé figure une seule fois dans son objet</translation>
    </message>
    <message>
        <source>elbow</source>
        <translation>coude</translation>
    </message>
    <message>
        <source>fence</source>
        <translation>clôture</translation>
    </message>
    <message>
        <source>fixture</source>
        <translation>montage</translation>
    </message>
    <message>
        <source>floor</source>
        <translation>sol</translation>
    </message>
    <message>
        <source>forearm</source>
        <translation>avant-bras</translation>
    </message>
    <message>
        <source>holder</source>
        <translation>porte-pièce</translation>
    </message>
    <message>
        <source>index: the list has only 1 entry</source>
        <translation>index : la liste n&apos;a qu&apos;une entrée</translation>
    </message>
    <message>
        <source>move the part on its table, or %1 in the cell file</source>
        <translation>déplacer la pièce sur sa table, ou %1 dans le fichier de cellule</translation>
    </message>
    <message>
        <source>move the substrate with the part by %1 along %2 of the part frame, take another one, or correct %3 in the cell file</source>
        <translation>déplacer le substrat avec la pièce de %1 selon %2 du repère pièce, en prendre un autre, ou corriger %3 dans le fichier de cellule</translation>
    </message>
    <message>
        <source>move the substrate with the part, take another one, or correct %1 in the cell file</source>
        <translation>déplacer le substrat avec la pièce, en prendre un autre, ou corriger %1 dans le fichier de cellule</translation>
    </message>
    <message>
        <source>neck</source>
        <translation>col</translation>
    </message>
    <message>
        <source>no plugin provides the component &apos;%1&apos;</source>
        <translation>aucune extension ne fournit le composant « %1 »</translation>
    </message>
    <message>
        <source>no post-processor that is installed writes for %1: check every joint value and frame before the program runs</source>
        <translation>aucun post-processeur installé n&apos;écrit pour %1 : vérifier chaque valeur d&apos;axe et chaque repère avant d&apos;exécuter le programme</translation>
    </message>
    <message>
        <source>nozzle</source>
        <translation>buse</translation>
    </message>
    <message>
        <source>pedestal</source>
        <translation>socle</translation>
    </message>
    <message>
        <source>platter</source>
        <translation>plateau tournant</translation>
    </message>
    <message>
        <source>raise tcp_acceleration if the robot can do more, smooth the path, allow more rounding of corners (corner_radius) or lower the travel speed; lower min_speed_ratio only where the process bears it</source>
        <translation>augmenter tcp_acceleration si le robot peut davantage, lisser la trajectoire, permettre plus d&apos;arrondi aux coins (corner_radius) ou baisser la vitesse d&apos;avance ; ne baisser min_speed_ratio que si le procédé le supporte</translation>
    </message>
    <message>
        <source>rename one of the operations; if the output sets program_name, leave it empty, so that each program bears the name of its operation</source>
        <translation>renommer l&apos;une des opérations ; si la sortie fixe program_name, le laisser vide, pour que chaque programme porte le nom de son opération</translation>
    </message>
    <message>
        <source>set &quot;branch&quot; to keep one configuration</source>
        <translation>fixer « branch » pour garder une configuration</translation>
    </message>
    <message>
        <source>set program_name to a name of this form</source>
        <translation>donner à program_name un nom de cette forme</translation>
    </message>
    <message>
        <source>shorten acceleration_time if the robot&apos;s axes are faster, smooth the path, allow more rounding of corners (corner_radius) or lower the travel speed; lower min_speed_ratio only where the process bears it</source>
        <translation>raccourcir acceleration_time si les axes du robot sont plus rapides, lisser la trajectoire, permettre plus d&apos;arrondi aux coins (corner_radius) ou baisser la vitesse d&apos;avance ; ne baisser min_speed_ratio que si le procédé le supporte</translation>
    </message>
    <message>
        <source>shoulder</source>
        <translation>épaule</translation>
    </message>
    <message>
        <source>smooth the path (axis_rate bounds the turn of its build direction), raise vertical_tolerance or lower the travel speed; lower min_speed_ratio only where the process bears it</source>
        <translation>lisser la trajectoire (axis_rate borne la rotation de sa direction de construction), augmenter vertical_tolerance ou baisser la vitesse d&apos;avance ; ne baisser min_speed_ratio que si le procédé le supporte</translation>
    </message>
    <message>
        <source>spindle</source>
        <translation>broche</translation>
    </message>
    <message>
        <source>stand</source>
        <translation>support</translation>
    </message>
    <message>
        <source>table</source>
        <translation>table</translation>
    </message>
    <message>
        <source>the acceleration of the torch (tcp_acceleration)</source>
        <translation>l&apos;accélération de la torche (tcp_acceleration)</translation>
    </message>
    <message>
        <source>the configuration %1 is taken, which has no violation: %2, which comes first, has %3</source>
        <translation>la configuration %1 est retenue, qui n&apos;a aucune violation : %2, qui vient en premier, en a %3</translation>
    </message>
    <message>
        <source>the configuration %1 is taken, which has no violation: %2, which comes first, has 1</source>
        <translation>la configuration %1 est retenue, qui n&apos;a aucune violation : %2, qui vient en premier, en a 1</translation>
    </message>
    <message>
        <source>the operations &apos;%1&apos; and &apos;%2&apos; both get the program %3 of output &apos;%4&apos;</source>
        <translation>les opérations « %1 » et « %2 » reçoivent toutes deux le programme %3 de la sortie « %4 »</translation>
    </message>
    <message>
        <source>the substrate stands %1 deep inside %2, at (%3, %4, %5) of the part</source>
        <translation>le substrat pénètre de %1 dans %2, en (%3 ; %4 ; %5) de la pièce</translation>
    </message>
    <message>
        <source>the torch needs %1 s for %2 mm with the arc on, %3 mm/s or %4 % of the wanted speed, and %5 mm/s at the slowest point; nearest to its limit is the acceleration of the torch</source>
        <translation>la torche met %1 s pour %2 mm avec l&apos;arc allumé, %3 mm/s soit %4 % de la vitesse voulue, et %5 mm/s au point le plus lent ; le plus près de sa limite est l&apos;accélération de la torche</translation>
    </message>
    <message>
        <source>the torch&apos;s cable is twisted by up to %1 at %2; its limit is %3 to both sides</source>
        <translation>le câble de la torche est tordu de %1 au plus sur %2 ; sa limite est de %3 des deux côtés</translation>
    </message>
    <message>
        <source>tilt unit</source>
        <translation>unité d&apos;inclinaison</translation>
    </message>
    <message>
        <source>torch body</source>
        <translation>corps de torche</translation>
    </message>
    <message>
        <source>upper arm</source>
        <translation>bras</translation>
    </message>
    <message>
        <source>use %1, which writes for %2</source>
        <translation>utiliser %1, qui écrit pour %2</translation>
    </message>
    <message>
        <source>wrist</source>
        <translation>poignet</translation>
    </message>
    <message>
        <source>wrist plate</source>
        <translation>bride du poignet</translation>
    </message>
    <message>
        <source>write speeds with more decimals (speed_decimals)</source>
        <translation>écrire les vitesses avec plus de décimales (speed_decimals)</translation>
    </message>
    <message>
        <source>Wrist N or F, elbow up or down, shoulder to the front or back. Automatic takes one that reaches all points inside the limits, if it can with the shoulder to the front and the elbow up, and with the largest margin; where that one collides, breaks limits or twists the cable too far, the first one without violations.</source>
        <translation>Poignet N ou F, coude en haut ou en bas, épaule vers l&apos;avant ou l&apos;arrière. Automatique en prend une qui atteint tous les points dans les limites, si possible l&apos;épaule vers l&apos;avant et le coude en haut, et avec la plus grande marge ; si celle-ci entre en collision, dépasse des limites ou tord trop le câble, la première sans violation.</translation>
    </message>
    <message>
        <source>%1 more findings of the kind %2 are not listed</source>
        <translation>%1 autres constats de type %2 ne sont pas listés</translation>
    </message>
    <message>
        <source>add {&quot;id&quot;: &quot;%1&quot;, &quot;version&quot;: &quot;%2&quot;} to &quot;plugins&quot;, so that others learn what they need</source>
        <translation>ajouter {&quot;id&quot;: &quot;%1&quot;, &quot;version&quot;: &quot;%2&quot;} à &quot;plugins&quot;, pour que d&apos;autres sachent ce qu&apos;il leur faut</translation>
    </message>
    <message>
        <source>an object has more than %1 keys</source>
        <translation>un objet a plus de %1 clés</translation>
    </message>
    <message>
        <source>check the result, then write version %1 into &quot;plugins&quot;</source>
        <translation>vérifier le résultat, puis écrire la version %1 dans &quot;plugins&quot;</translation>
    </message>
    <message>
        <source>install it, or take it out of &quot;plugins&quot;; `camcli plugins list` shows what is there</source>
        <translation>l&apos;installer, ou le retirer de &quot;plugins&quot; ; `camcli plugins list` montre ce qui est présent</translation>
    </message>
    <message>
        <source>install version %1 or a later one</source>
        <translation>installer la version %1 ou une plus récente</translation>
    </message>
    <message>
        <source>the project names the plugin %1, which is not installed</source>
        <translation>le projet nomme le plugin %1, qui n&apos;est pas installé</translation>
    </message>
    <message>
        <source>the project needs version %2 of the plugin %1; version %3 is installed</source>
        <translation>le projet demande la version %2 du plugin %1 ; la version %3 est installée</translation>
    </message>
    <message>
        <source>the project uses the plugin %1 without naming it</source>
        <translation>le projet utilise le plugin %1 sans le nommer</translation>
    </message>
    <message>
        <source>the project was made with version %2 of the plugin %1; version %3 is installed</source>
        <translation>le projet a été fait avec la version %2 du plugin %1 ; la version %3 est installée</translation>
    </message>
    <message>
        <source>%1: is no key here; it is kept in the file and has no effect</source>
        <translation>%1 : n&apos;est pas une clé à cet endroit ; elle reste dans le fichier sans effet</translation>
    </message>
    <message>
        <source>keys: %1</source>
        <translation>clés : %1</translation>
    </message>
</context>
<context>
    <name>text</name>
    <message>
        <source>Hint: %1</source>
        <translation>Conseil : %1</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Couche</translation>
    </message>
    <message>
        <source>Feature</source>
        <translation>Nature</translation>
    </message>
    <message>
        <source>Bead height</source>
        <translation>Hauteur de cordon</translation>
    </message>
    <message>
        <source>Inter-layer distance</source>
        <translation>Distance inter-couches</translation>
    </message>
    <message>
        <source>Bead width</source>
        <translation>Largeur de cordon</translation>
    </message>
    <message>
        <source>Travel speed</source>
        <translation>Vitesse d’avance</translation>
    </message>
    <message>
        <source>Predicted TCP speed</source>
        <translation>Vitesse prévue du TCP</translation>
    </message>
    <message>
        <source>Wire feed speed</source>
        <translation>Vitesse de fil</translation>
    </message>
    <message>
        <source>Torch tilt</source>
        <translation>Inclinaison de la torche</translation>
    </message>
    <message>
        <source>Overhang</source>
        <translation>Surplomb</translation>
    </message>
    <message>
        <source>Reach margin</source>
        <translation>Marge d’atteinte</translation>
    </message>
    <message>
        <source>Distance to wrist singularity</source>
        <translation>Distance à la singularité du poignet</translation>
    </message>
    <message>
        <source>Joint-limit margin</source>
        <translation>Marge aux butées</translation>
    </message>
    <message>
        <source>Distance to collision</source>
        <translation>Distance de collision</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Constats</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Nothing found</source>
        <translation>Rien à signaler</translation>
    </message>
    <message>
        <source>Information</source>
        <translation>Information</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
    <message>
        <source>Violation</source>
        <translation>Violation</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Paroi</translation>
    </message>
    <message>
        <source>Inset</source>
        <translation>Paroi intérieure</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Remplissage</translation>
    </message>
    <message>
        <source>Junction</source>
        <translation>Jonction</translation>
    </message>
    <message>
        <source>Cladding</source>
        <translation>Rechargement</translation>
    </message>
    <message>
        <source>Imported</source>
        <translation>Importé</translation>
    </message>
</context>
<context>
    <name>wcam::gui::CellDialog</name>
    <message>
        <source>Choose a cell</source>
        <translation>Choisir une cellule</translation>
    </message>
    <message>
        <source>Other file…</source>
        <translation>Autre fichier…</translation>
    </message>
    <message>
        <source>Cells (*.json)</source>
        <translation>Cellules (*.json)</translation>
    </message>
</context>
<context>
    <name>wcam::gui::CommandPalette</name>
    <message>
        <source>Command palette</source>
        <translation>Palette de commandes</translation>
    </message>
    <message>
        <source>Type the name of a command</source>
        <translation>Tapez le nom d’une commande</translation>
    </message>
</context>
<context>
    <name>wcam::gui::DiagnosticsTable</name>
    <message>
        <source> layer %1</source>
        <translation> couche %1</translation>
    </message>
    <message>
        <source> bead %1</source>
        <translation> cordon %1</translation>
    </message>
    <message>
        <source> point %1</source>
        <translation> point %1</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lieu</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Constat</translation>
    </message>
    <message>
        <source>Remedy</source>
        <translation>Remède</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Constats</translation>
    </message>
    <message>
        <source>Filter findings</source>
        <translation>Filtrer les constats</translation>
    </message>
    <message>
        <source>Show errors and violations</source>
        <translation>Montrer erreurs et violations</translation>
    </message>
    <message>
        <source>Show warnings</source>
        <translation>Montrer les avertissements</translation>
    </message>
    <message>
        <source>Show information</source>
        <translation>Montrer les informations</translation>
    </message>
    <message>
        <source>A hint: it was not proven on the whole operation.</source>
        <translation>Une piste&#xa0;: elle n’a pas été vérifiée sur toute l’opération.</translation>
    </message>
    <message>
        <source>This was tried on the whole operation.</source>
        <translation>Cela a été essayé sur toute l’opération.</translation>
    </message>
    <message>
        <source>Applies the remedy, as one step that can be undone</source>
        <translation>Applique le remède en une étape, qui peut être annulée</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>Apply remedy</source>
        <translation>Appliquer le remède</translation>
    </message>
    <message>
        <source>Applies the remedy of the selected finding, as one step that can be undone</source>
        <translation>Applique le remède du constat sélectionné en une étape, qui peut être annulée</translation>
    </message>
</context>
<context>
    <name>wcam::gui::EditDialog</name>
    <message>
        <source>Add an edit of the toolpath</source>
        <translation>Ajouter une retouche de la trajectoire</translation>
    </message>
    <message>
        <source>What the edit does</source>
        <translation>Ce que fait la retouche</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Opération</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Identifiant</translation>
    </message>
</context>
<context>
    <name>wcam::gui::ExportDialog</name>
    <message>
        <source>Export programs</source>
        <translation>Exporter les programmes</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>Choisir un dossier</translation>
    </message>
    <message>
        <source>Also write tables of all points (CSV)</source>
        <translation>Écrire aussi les tables de tous les points (CSV)</translation>
    </message>
    <message>
        <source>Only check, write nothing</source>
        <translation>Vérifier seulement, ne rien écrire</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Sorties</translation>
    </message>
    <message>
        <source>Operations</source>
        <translation>Opérations</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>Choose at least one operation.</source>
        <translation>Choisissez au moins une opération.</translation>
    </message>
    <message>
        <source>Choose at least one output.</source>
        <translation>Choisissez au moins une sortie.</translation>
    </message>
    <message>
        <source>Cancelled: nothing was written.</source>
        <translation>Annulé : rien n’a été écrit.</translation>
    </message>
    <message>
        <source>Operation &apos;%1&apos; violates checks and gets no robot program.</source>
        <translation>L’opération « %1 » viole des contrôles et n’obtient pas de programme robot.</translation>
    </message>
    <message>
        <source>Everything is written.</source>
        <translation>Tout est écrit.</translation>
    </message>
    <message>
        <source>Everything is in order.</source>
        <translation>Tout est en ordre.</translation>
    </message>
    <message>
        <source>&lt;li&gt;%1 (%L2 bytes)&lt;/li&gt;</source>
        <translation>&lt;li&gt;%1 (%L2 octets)&lt;/li&gt;</translation>
    </message>
    <message>
        <source>Not written again and perhaps out of date: %1</source>
        <translation>Non réécrits et peut-être périmés : %1</translation>
    </message>
    <message>
        <source>Output &apos;%1&apos; of operation &apos;%2&apos; violates checks and is not written.</source>
        <translation>La sortie « %1 » de l’opération « %2 » enfreint des contrôles et n’est pas écrite.</translation>
    </message>
</context>
<context>
    <name>wcam::gui::ImportDialog</name>
    <message>
        <source>Import %1</source>
        <translation>Importer %1</translation>
    </message>
    <message>
        <source>Stand it in the middle of the plate</source>
        <translation>La poser au milieu de la plaque</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>Id of the part</source>
        <translation>Identifiant de la pièce</translation>
    </message>
    <message>
        <source>How the file is read</source>
        <translation>Lecture du fichier</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Dimensions</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangles</translation>
    </message>
    <message>
        <source>CAD faces and edges</source>
        <translation>Faces et arêtes CAO</translation>
    </message>
    <message>
        <source>Free curves</source>
        <translation>Courbes libres</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Fermée</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message numerus="yes">
        <source>no, %n border(s)</source>
        <translation>
            <numerusform>non, %n bord</numerusform>
            <numerusform>non, %n bords</numerusform>
        </translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Morceaux</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Aire</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Corps</translation>
    </message>
    <message>
        <source>What was found and repaired</source>
        <translation>Ce qui a été trouvé et réparé</translation>
    </message>
</context>
<context>
    <name>wcam::gui::JointPlot</name>
    <message>
        <source>What is plotted</source>
        <translation>Grandeur tracée</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Accélération</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>All, % of limits</source>
        <translation>Tous, % des limites</translation>
    </message>
</context>
<context>
    <name>wcam::gui::LayerSlider</name>
    <message>
        <source>Layers shown</source>
        <translation>Couches affichées</translation>
    </message>
    <message>
        <source>Layers shown: drag the thumbs, or the bar between them; X shows a single layer</source>
        <translation>Couches affichées : déplacez les curseurs ou la barre entre eux ; X montre une seule couche</translation>
    </message>
    <message numerus="yes">
        <source>%n layer(s)</source>
        <translation>
            <numerusform>%n couche</numerusform>
            <numerusform>%n couches</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>wcam::gui::Legend</name>
    <message>
        <source>Click: another quantity. Double click: limits of the colours.</source>
        <translation>Clic : autre grandeur. Double clic : limites des couleurs.</translation>
    </message>
    <message>
        <source>no values</source>
        <translation>pas de valeurs</translation>
    </message>
    <message>
        <source>Limits of the colours</source>
        <translation>Limites des couleurs</translation>
    </message>
    <message>
        <source>Empty: the limits of the values.</source>
        <translation>Vide : les limites des valeurs.</translation>
    </message>
    <message>
        <source>Lowest (%1)</source>
        <translation>Minimum (%1)</translation>
    </message>
    <message>
        <source>Highest (%1)</source>
        <translation>Maximum (%1)</translation>
    </message>
    <message>
        <source>Lowest</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>Maximum</translation>
    </message>
</context>
<context>
    <name>wcam::gui::LogView</name>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
    </message>
</context>
<context>
    <name>wcam::gui::MainWindow</name>
    <message>
        <source>Close the message</source>
        <translation>Fermer le message</translation>
    </message>
    <message>
        <source>The 3D view needs a display.</source>
        <translation>La vue 3D a besoin d’un affichage.</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>Axis of the section: click for the next one</source>
        <translation>Axe de la coupe : cliquez pour le suivant</translation>
    </message>
    <message>
        <source>Place of the section</source>
        <translation>Position de la coupe</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projet</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Constats</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Procédé</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Résultats</translation>
    </message>
    <message>
        <source>Cancel (Esc)</source>
        <translation>Annuler (Échap)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;New…</source>
        <translation>&amp;Nouveau…</translation>
    </message>
    <message>
        <source>New project from a template</source>
        <translation>Nouveau projet à partir d’un modèle</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>Ouvrir un projet</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Ouvrir un fichier &amp;récent</translation>
    </message>
    <message>
        <source>Projects that were open lately</source>
        <translation>Projets ouverts récemment</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Enregistrer le projet</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>Save the project under another name</source>
        <translation>Enregistrer le projet sous un autre nom</translation>
    </message>
    <message>
        <source>&amp;Import part…</source>
        <translation>&amp;Importer une pièce…</translation>
    </message>
    <message>
        <source>Import a CAD or mesh file as a part</source>
        <translation>Importer un fichier CAO ou de maillage comme pièce</translation>
    </message>
    <message>
        <source>&amp;Export programs…</source>
        <translation>E&amp;xporter les programmes…</translation>
    </message>
    <message>
        <source>Compute everything and write the robot programs</source>
        <translation>Tout calculer et écrire les programmes robot</translation>
    </message>
    <message>
        <source>Save &amp;picture…</source>
        <translation>Enregistrer une i&amp;mage…</translation>
    </message>
    <message>
        <source>Save the 3D view as a PNG file</source>
        <translation>Enregistrer la vue 3D en PNG</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Close the program</source>
        <translation>Fermer le programme</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Take the last change back</source>
        <translation>Annuler la dernière modification</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Make the change again</source>
        <translation>Refaire la modification</translation>
    </message>
    <message>
        <source>&amp;Copy node</source>
        <translation>&amp;Copier le nœud</translation>
    </message>
    <message>
        <source>Copy the selected node as text</source>
        <translation>Copier le nœud choisi comme texte</translation>
    </message>
    <message>
        <source>&amp;Paste node</source>
        <translation>C&amp;oller le nœud</translation>
    </message>
    <message>
        <source>Add the copied node</source>
        <translation>Ajouter le nœud copié</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Dupliquer</translation>
    </message>
    <message>
        <source>Add a copy of the selected node</source>
        <translation>Ajouter une copie du nœud choisi</translation>
    </message>
    <message>
        <source>Re&amp;name…</source>
        <translation>Re&amp;nommer…</translation>
    </message>
    <message>
        <source>Give the selected node another id</source>
        <translation>Donner un autre identifiant au nœud choisi</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Remove the selected node</source>
        <translation>Supprimer le nœud choisi</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>&amp;Monter</translation>
    </message>
    <message>
        <source>Move the selected node up in its list</source>
        <translation>Monter le nœud choisi dans sa liste</translation>
    </message>
    <message>
        <source>Move do&amp;wn</source>
        <translation>D&amp;escendre</translation>
    </message>
    <message>
        <source>Move the selected node down in its list</source>
        <translation>Descendre le nœud choisi dans sa liste</translation>
    </message>
    <message>
        <source>&amp;Find parameter</source>
        <translation>Chercher un paramè&amp;tre</translation>
    </message>
    <message>
        <source>Search in the parameters of the selected node</source>
        <translation>Chercher dans les paramètres du nœud choisi</translation>
    </message>
    <message>
        <source>Command p&amp;alette…</source>
        <translation>&amp;Palette de commandes…</translation>
    </message>
    <message>
        <source>Find a command by its name</source>
        <translation>Trouver une commande par son nom</translation>
    </message>
    <message>
        <source>&amp;Project</source>
        <translation>&amp;Projet</translation>
    </message>
    <message>
        <source>Add &amp;operation…</source>
        <translation>Ajouter une &amp;opération…</translation>
    </message>
    <message>
        <source>Choose a strategy and add an operation</source>
        <translation>Choisir une stratégie et ajouter une opération</translation>
    </message>
    <message>
        <source>Add &amp;substrate</source>
        <translation>Ajouter un &amp;substrat</translation>
    </message>
    <message>
        <source>Add a plate to build on</source>
        <translation>Ajouter une plaque sur laquelle construire</translation>
    </message>
    <message>
        <source>Add &amp;guide curve</source>
        <translation>Ajouter une courbe &amp;guide</translation>
    </message>
    <message>
        <source>Add a guide curve; picked edges become one as well</source>
        <translation>Ajouter une courbe guide ; une arête choisie peut aussi en devenir une</translation>
    </message>
    <message>
        <source>Add &amp;process</source>
        <translation>Ajouter un &amp;procédé</translation>
    </message>
    <message>
        <source>Add process parameters</source>
        <translation>Ajouter des paramètres de procédé</translation>
    </message>
    <message>
        <source>Add ou&amp;tput</source>
        <translation>Ajouter une sor&amp;tie</translation>
    </message>
    <message>
        <source>Add a robot program to write</source>
        <translation>Ajouter un programme robot à écrire</translation>
    </message>
    <message>
        <source>Choose &amp;cell…</source>
        <translation>Choisir la &amp;cellule…</translation>
    </message>
    <message>
        <source>&amp;Drop part on plate</source>
        <translation>Po&amp;ser la pièce sur la plaque</translation>
    </message>
    <message>
        <source>Move the selected part so that it stands in the middle of the plate</source>
        <translation>Déplacer la pièce choisie au milieu de la plaque</translation>
    </message>
    <message>
        <source>&amp;Regenerate</source>
        <translation>&amp;Recalculer</translation>
    </message>
    <message>
        <source>Compute what is out of date</source>
        <translation>Calculer ce qui est périmé</translation>
    </message>
    <message>
        <source>C&amp;ancel</source>
        <translation>A&amp;nnuler</translation>
    </message>
    <message>
        <source>Stop the computation; what is shown stays</source>
        <translation>Arrêter le calcul ; l’affichage reste</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Vue</translation>
    </message>
    <message>
        <source>Look from a fixed direction</source>
        <translation>Regarder d’une direction fixe</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Cadrer</translation>
    </message>
    <message>
        <source>Show everything</source>
        <translation>Tout montrer</translation>
    </message>
    <message>
        <source>&amp;Isometric</source>
        <translation>&amp;Isométrique</translation>
    </message>
    <message>
        <source>F&amp;ront</source>
        <translation>A&amp;vant</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>A&amp;rrière</translation>
    </message>
    <message>
        <source>Ri&amp;ght</source>
        <translation>&amp;Droite</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Gauche</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>&amp;Dessus</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>D&amp;essous</translation>
    </message>
    <message>
        <source>&amp;Parallel projection</source>
        <translation>&amp;Projection parallèle</translation>
    </message>
    <message>
        <source>Without perspective</source>
        <translation>Sans perspective</translation>
    </message>
    <message>
        <source>How the part is drawn</source>
        <translation>Dessin de la pièce</translation>
    </message>
    <message>
        <source>Part s&amp;olid</source>
        <translation>Pièce &amp;opaque</translation>
    </message>
    <message>
        <source>Part tr&amp;anslucent</source>
        <translation>Pièce tr&amp;anslucide</translation>
    </message>
    <message>
        <source>Part e&amp;dges</source>
        <translation>Arêtes de la pièce</translation>
    </message>
    <message>
        <source>Part &amp;hidden</source>
        <translation>Pièce cac&amp;hée</translation>
    </message>
    <message>
        <source>&amp;Cell</source>
        <translation>Ce&amp;llule</translation>
    </message>
    <message>
        <source>Show robot and positioner, and move the part with them</source>
        <translation>Montrer robot et positionneur, et bouger la pièce avec eux</translation>
    </message>
    <message>
        <source>&amp;Substrate</source>
        <translation>&amp;Substrat</translation>
    </message>
    <message>
        <source>Show the substrate</source>
        <translation>Montrer le substrat</translation>
    </message>
    <message>
        <source>Tra&amp;vel moves</source>
        <translation>&amp;Trajets à vide</translation>
    </message>
    <message>
        <source>Show the moves between beads</source>
        <translation>Montrer les trajets entre cordons</translation>
    </message>
    <message>
        <source>Torc&amp;h</source>
        <translation>Torc&amp;he</translation>
    </message>
    <message>
        <source>Show the torch during playback</source>
        <translation>Montrer la torche pendant la lecture</translation>
    </message>
    <message>
        <source>Le&amp;gend</source>
        <translation>Lége&amp;nde</translation>
    </message>
    <message>
        <source>Show what the colours mean</source>
        <translation>Montrer le sens des couleurs</translation>
    </message>
    <message>
        <source>Colour b&amp;y</source>
        <translation>Colorer pa&amp;r</translation>
    </message>
    <message>
        <source>What the colours of the beads show</source>
        <translation>Grandeur montrée par les couleurs</translation>
    </message>
    <message>
        <source>Colour li&amp;mits…</source>
        <translation>Li&amp;mites des couleurs…</translation>
    </message>
    <message>
        <source>Set the ends of the colour scale</source>
        <translation>Fixer les bornes de l’échelle de couleurs</translation>
    </message>
    <message>
        <source>Se&amp;ction plane</source>
        <translation>Plan de &amp;coupe</translation>
    </message>
    <message>
        <source>Cut what is shown by a plane</source>
        <translation>Couper la vue par un plan</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>M&amp;esurer</translation>
    </message>
    <message>
        <source>Distance between two picked places</source>
        <translation>Distance entre deux endroits choisis</translation>
    </message>
    <message>
        <source>Pick two places to measure</source>
        <translation>Choisissez deux endroits à mesurer</translation>
    </message>
    <message>
        <source>Show this page of the results</source>
        <translation>Montrer cette page des résultats</translation>
    </message>
    <message>
        <source>Show or hide this panel</source>
        <translation>Montrer ou cacher ce panneau</translation>
    </message>
    <message>
        <source>Pro&amp;ject panel</source>
        <translation>Panneau pro&amp;jet</translation>
    </message>
    <message>
        <source>Parameter pa&amp;nel</source>
        <translation>Panneau paramètres</translation>
    </message>
    <message>
        <source>Res&amp;ults panel</source>
        <translation>Panneau rés&amp;ultats</translation>
    </message>
    <message>
        <source>Dar&amp;k theme</source>
        <translation>Thème som&amp;bre</translation>
    </message>
    <message>
        <source>Light letters on dark</source>
        <translation>Lettres claires sur fond sombre</translation>
    </message>
    <message>
        <source>P&amp;layback</source>
        <translation>&amp;Lecture</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Lire ou suspendre</translation>
    </message>
    <message>
        <source>Play the moves</source>
        <translation>Lire les mouvements</translation>
    </message>
    <message>
        <source>&amp;Next move</source>
        <translation>Mouvement s&amp;uivant</translation>
    </message>
    <message>
        <source>One move forward</source>
        <translation>Avancer d’un mouvement</translation>
    </message>
    <message>
        <source>P&amp;revious move</source>
        <translation>Mouvement p&amp;récédent</translation>
    </message>
    <message>
        <source>One move back</source>
        <translation>Reculer d’un mouvement</translation>
    </message>
    <message>
        <source>To the &amp;start</source>
        <translation>Au &amp;début</translation>
    </message>
    <message>
        <source>Before the first move of the layers shown</source>
        <translation>Avant le premier mouvement des couches affichées</translation>
    </message>
    <message>
        <source>To the &amp;end</source>
        <translation>À la &amp;fin</translation>
    </message>
    <message>
        <source>After the last move of the layers shown</source>
        <translation>Après le dernier mouvement des couches affichées</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>&amp;Plus vite</translation>
    </message>
    <message>
        <source>Play faster</source>
        <translation>Lire plus vite</translation>
    </message>
    <message>
        <source>Slo&amp;wer</source>
        <translation>Plus &amp;lentement</translation>
    </message>
    <message>
        <source>Play slower</source>
        <translation>Lire plus lentement</translation>
    </message>
    <message>
        <source>Layer &amp;up</source>
        <translation>Couche de plu&amp;s</translation>
    </message>
    <message>
        <source>Show one layer more</source>
        <translation>Montrer une couche de plus</translation>
    </message>
    <message>
        <source>Layer &amp;down</source>
        <translation>Couche de m&amp;oins</translation>
    </message>
    <message>
        <source>Show one layer less</source>
        <translation>Montrer une couche de moins</translation>
    </message>
    <message>
        <source>&amp;All layers</source>
        <translation>&amp;Toutes les couches</translation>
    </message>
    <message>
        <source>Show all layers</source>
        <translation>Montrer toutes les couches</translation>
    </message>
    <message>
        <source>Si&amp;ngle layer</source>
        <translation>Couche seu&amp;le</translation>
    </message>
    <message>
        <source>Show one layer alone</source>
        <translation>Montrer une seule couche</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Aide</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>&amp;Raccourcis clavier</translation>
    </message>
    <message>
        <source>All shortcuts</source>
        <translation>Tous les raccourcis</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Raccourcis clavier</translation>
    </message>
    <message>
        <source>&amp;About WCAM</source>
        <translation>À &amp;propos de WCAM</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Version et licence</translation>
    </message>
    <message>
        <source>About WCAM</source>
        <translation>À propos de WCAM</translation>
    </message>
    <message>
        <source>&lt;h3&gt;WCAM %1&lt;/h3&gt;&lt;p&gt;CAM for robotic wire-arc additive manufacturing.&lt;/p&gt;&lt;p&gt;Licence: GPL-3.0-or-later&lt;/p&gt;</source>
        <translation>&lt;h3&gt;WCAM %1&lt;/h3&gt;&lt;p&gt;FAO pour la fabrication additive arc-fil robotisée.&lt;/p&gt;&lt;p&gt;Licence : GPL-3.0-or-later&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Annuler : %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rétablir : %1</translation>
    </message>
    <message>
        <source>WCAM projects (*.wcam)</source>
        <translation>Projets WCAM (*.wcam)</translation>
    </message>
    <message>
        <source>CAD and mesh files (%1)</source>
        <translation>Fichiers CAO et maillages (%1)</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Modifications non enregistrées</translation>
    </message>
    <message>
        <source>The project has changes that are not saved:</source>
        <translation>Le projet a des modifications non enregistrées :</translation>
    </message>
    <message>
        <source>Open project</source>
        <translation>Ouvrir un projet</translation>
    </message>
    <message>
        <source>Recover the project</source>
        <translation>Récupérer le projet</translation>
    </message>
    <message>
        <source>%1 was not closed properly. Changes that were not saved can be recovered.</source>
        <translation>%1 n’a pas été fermé correctement. Les modifications non enregistrées peuvent être récupérées.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Récupérer</translation>
    </message>
    <message>
        <source>Open as saved</source>
        <translation>Ouvrir tel qu’enregistré</translation>
    </message>
    <message>
        <source>Another program has this project open (%1). It can be changed here, but only saved under another name.</source>
        <translation>Un autre programme a ouvert ce projet (%1). Il peut être modifié ici, mais seulement enregistré sous un autre nom.</translation>
    </message>
    <message>
        <source>The changes that were not saved are back. Save the project to keep them.</source>
        <translation>Les modifications non enregistrées sont de retour. Enregistrez le projet pour les garder.</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Enregistrer le projet</translation>
    </message>
    <message>
        <source>Import part</source>
        <translation>Importer une pièce</translation>
    </message>
    <message>
        <source>The project was written by a newer version and cannot be changed.</source>
        <translation>Le projet a été écrit par une version plus récente et ne peut pas être modifié.</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importer %1</translation>
    </message>
    <message>
        <source>Where is the file of %1?</source>
        <translation>Où est le fichier de %1 ?</translation>
    </message>
    <message>
        <source>The part must be read before it can be placed.</source>
        <translation>La pièce doit être lue avant d’être placée.</translation>
    </message>
    <message>
        <source>Add operation %1</source>
        <translation>Ajouter l’opération %1</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>New id of %1</source>
        <translation>Nouvel identifiant de %1</translation>
    </message>
    <message>
        <source>The clipboard holds no node of a project.</source>
        <translation>Le presse-papiers ne contient pas de nœud de projet.</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>sans titre</translation>
    </message>
    <message>
        <source>(read only)</source>
        <translation>(lecture seule)</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>being computed</source>
        <translation>en cours de calcul</translation>
    </message>
    <message>
        <source>out of date: F5 computes it</source>
        <translation>périmé : F5 le calcule</translation>
    </message>
    <message>
        <source>%1, %L2 triangles</source>
        <translation>%1, %L2 triangles</translation>
    </message>
    <message numerus="yes">
        <source>%n layer(s)</source>
        <translation>
            <numerusform>%n couche</numerusform>
            <numerusform>%n couches</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 violations, %2 warnings</source>
        <translation>%1 violations, %2 avertissements</translation>
    </message>
    <message>
        <source>project</source>
        <translation>projet</translation>
    </message>
    <message>
        <source>Findings (%1)</source>
        <translation>Constats (%1)</translation>
    </message>
    <message>
        <source>Out of date — F5 computes it</source>
        <translation>Périmé — F5 le calcule</translation>
    </message>
    <message>
        <source>Computing …</source>
        <translation>Calcul …</translation>
    </message>
    <message>
        <source>%1: %2 layers, %L3 points, %4</source>
        <translation>%1 : %2 couches, %L3 points, %4</translation>
    </message>
    <message>
        <source>Drop a CAD file here, or choose File › Import part</source>
        <translation>Déposez ici un fichier CAO, ou choisissez Fichier › Importer une pièce</translation>
    </message>
    <message>
        <source>The project has no output.</source>
        <translation>Le projet n’a pas de sortie.</translation>
    </message>
    <message>
        <source>There is no program yet.</source>
        <translation>Il n’y a pas encore de programme.</translation>
    </message>
    <message>
        <source>Program text</source>
        <translation>Texte du programme</translation>
    </message>
    <message>
        <source>Pick the second place</source>
        <translation>Choisissez le second endroit</translation>
    </message>
    <message>
        <source>Distance %1 (Δx %2, Δy %3, Δz %4)</source>
        <translation>Distance %1 (Δx %2, Δy %3, Δz %4)</translation>
    </message>
    <message>
        <source>&lt;b&gt;Layer %1, bead %2, point %3&lt;/b&gt;</source>
        <translation>&lt;b&gt;Couche %1, cordon %2, point %3&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>&lt;b&gt;Face %1&lt;/b&gt;&lt;br/&gt;%2</source>
        <translation>&lt;b&gt;Face %1&lt;/b&gt;&lt;br/&gt;%2</translation>
    </message>
    <message>
        <source>&lt;b&gt;Edge %1&lt;/b&gt; %2&lt;br/&gt;length %3 mm</source>
        <translation>&lt;b&gt;Arête %1&lt;/b&gt; %2&lt;br/&gt;longueur %3 mm</translation>
    </message>
    <message>
        <source>Use edge %1 as guide curve</source>
        <translation>Prendre l’arête %1 comme courbe guide</translation>
    </message>
    <message>
        <source>Guide curve from edge %1</source>
        <translation>Courbe guide de l’arête %1</translation>
    </message>
    <message>
        <source>Take face %1 from the working surface</source>
        <translation>Ôter la face %1 de la surface de travail</translation>
    </message>
    <message>
        <source>Add face %1 to the working surface</source>
        <translation>Ajouter la face %1 à la surface de travail</translation>
    </message>
    <message>
        <source>Set part on face %1</source>
        <translation>Poser la pièce sur la face %1</translation>
    </message>
    <message>
        <source>Show layer %1 alone</source>
        <translation>Montrer la couche %1 seule</translation>
    </message>
    <message>
        <source>Seams towards this point</source>
        <translation>Débuts de cordon vers ce point</translation>
    </message>
    <message>
        <source>Seams towards a point</source>
        <translation>Débuts de cordon vers un point</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Enregistrer une image</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Images (*.png)</translation>
    </message>
    <message>
        <source>The picture cannot be written to %1</source>
        <translation>L’image ne peut pas être écrite dans %1</translation>
    </message>
    <message>
        <source>The program was not closed properly. The project that was never saved can be recovered.</source>
        <translation>Le programme n’a pas été fermé correctement. Le projet jamais enregistré peut être récupéré.</translation>
    </message>
    <message>
        <source>Locate file…</source>
        <translation>Retrouver le fichier…</translation>
    </message>
    <message>
        <source>Save repor&amp;t…</source>
        <translation>Enregistrer un rappor&amp;t…</translation>
    </message>
    <message>
        <source>Save figures, plots, findings and settings as one HTML page</source>
        <translation>Enregistrer chiffres, courbes, constats et réglages en une page HTML</translation>
    </message>
    <message>
        <source>Save report</source>
        <translation>Enregistrer le rapport</translation>
    </message>
    <message>
        <source>Web pages (*.html);;PDF documents (*.pdf)</source>
        <translation>Pages web (*.html);;Documents PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>The report is written to %1</source>
        <translation>Le rapport est écrit dans %1</translation>
    </message>
    <message>
        <source>Add &amp;edit of the toolpath…</source>
        <translation>Ajouter une &amp;retouche de la trajectoire…</translation>
    </message>
    <message>
        <source>Change the generated toolpath: seams, layers, speed, pauses, torch angles</source>
        <translation>Changer la trajectoire générée : débuts de cordon, couches, vitesse, pauses, angles de torche</translation>
    </message>
    <message>
        <source>Edit layer %1</source>
        <translation>Retoucher la couche %1</translation>
    </message>
    <message>
        <source>Edit layers %1 to %2</source>
        <translation>Retoucher les couches %1 à %2</translation>
    </message>
    <message>
        <source>Edit the toolpath here</source>
        <translation>Retoucher la trajectoire ici</translation>
    </message>
    <message>
        <source>Move the seams of the shown layers here</source>
        <translation>Amener ici les débuts de cordon des couches affichées</translation>
    </message>
    <message>
        <source>Pause before this bead</source>
        <translation>Pause avant ce cordon</translation>
    </message>
    <message>
        <source>Reverse this bead</source>
        <translation>Inverser ce cordon</translation>
    </message>
    <message>
        <source>Change the travel speed around this point</source>
        <translation>Changer la vitesse d’avance autour de ce point</translation>
    </message>
    <message>
        <source>Change the wire feed around this point</source>
        <translation>Changer la vitesse de fil autour de ce point</translation>
    </message>
    <message>
        <source>Change the lead angle around this point</source>
        <translation>Changer l’angle d’avance autour de ce point</translation>
    </message>
    <message>
        <source>Delete layer %1</source>
        <translation>Supprimer la couche %1</translation>
    </message>
    <message>
        <source>Repeat layer %1</source>
        <translation>Répéter la couche %1</translation>
    </message>
    <message>
        <source>Choose the robot cell, one that comes with the program or a file</source>
        <translation>Choisir la cellule robotisée, fournie avec le programme ou dans un fichier</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>cellule</translation>
    </message>
    <message>
        <source>The last path that could be computed — see Findings</source>
        <translation>La dernière trajectoire calculable — voir Constats</translation>
    </message>
    <message>
        <source>Remedy: %1</source>
        <translation>Remède&#xa0;: %1</translation>
    </message>
    <message>
        <source>The project file has changed</source>
        <translation>Le fichier du projet a changé</translation>
    </message>
    <message>
        <source>Another program has changed %1. Read the file again, or keep what is open here and replace the file when saving?</source>
        <translation>Un autre programme a modifié %1. Relire le fichier, ou garder ce qui est ouvert ici et remplacer le fichier à l&apos;enregistrement ?</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>Relire</translation>
    </message>
    <message>
        <source>Keep what is open</source>
        <translation>Garder ce qui est ouvert</translation>
    </message>
    <message>
        <source>Another program has changed %1. Read the file again and lose what you have not saved, or keep what is open here and replace the file when saving?</source>
        <translation>Un autre programme a modifié %1. Relire le fichier et perdre ce que vous n&apos;avez pas enregistré, ou garder ce qui est ouvert ici et remplacer le fichier à l&apos;enregistrement ?</translation>
    </message>
    <message>
        <source>Another program has this project open (%1), with changes that are not saved (%2). It can be changed here, but only saved under another name.</source>
        <translation>Un autre programme a ouvert ce projet (%1), avec des modifications non enregistrées (%2). Il peut être modifié ici, mais seulement enregistré sous un autre nom.</translation>
    </message>
</context>
<context>
    <name>wcam::gui::MoveBar</name>
    <message>
        <source>To the start</source>
        <translation>Au début</translation>
    </message>
    <message>
        <source>One move back</source>
        <translation>Reculer d’un mouvement</translation>
    </message>
    <message>
        <source>Play or pause (Space)</source>
        <translation>Lire ou suspendre (Espace)</translation>
    </message>
    <message>
        <source>One move forward</source>
        <translation>Avancer d’un mouvement</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>À la fin</translation>
    </message>
    <message>
        <source>Speed of the playback</source>
        <translation>Vitesse de lecture</translation>
    </message>
    <message>
        <source>Move shown</source>
        <translation>Mouvement affiché</translation>
    </message>
</context>
<context>
    <name>wcam::gui::NewDialog</name>
    <message>
        <source>New project</source>
        <translation>Nouveau projet</translation>
    </message>
    <message>
        <source>Empty project on a plate</source>
        <translation>Projet vide sur une plaque</translation>
    </message>
    <message>
        <source>Example: %1</source>
        <translation>Exemple : %1</translation>
    </message>
    <message>
        <source>Robot cell</source>
        <translation>Cellule robot</translation>
    </message>
    <message>
        <source>A plate, process parameters for steel wire of 1.2 mm and one output. Import a part next, then add an operation.</source>
        <translation>Une plaque, des paramètres de procédé pour fil d’acier de 1,2 mm et une sortie. Importez ensuite une pièce, puis ajoutez une opération.</translation>
    </message>
    <message>
        <source>A copy of the example. Saving it copies its part beside the project.</source>
        <translation>Une copie de l’exemple. L’enregistrer copie sa pièce à côté du projet.</translation>
    </message>
</context>
<context>
    <name>wcam::gui::OperationDialog</name>
    <message>
        <source>Add an operation</source>
        <translation>Ajouter une opération</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>a new plate</source>
        <translation>une nouvelle plaque</translation>
    </message>
    <message>
        <source>new parameters</source>
        <translation>de nouveaux paramètres</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Identifiant</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>Substrate</source>
        <translation>Substrat</translation>
    </message>
    <message>
        <source>Guide curve</source>
        <translation>Courbe guide</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Procédé</translation>
    </message>
    <message>
        <source>This strategy needs a guide curve. Right-click an edge in the 3D view to make one.</source>
        <translation>Cette stratégie a besoin d’une courbe guide. Un clic droit sur une arête de la vue 3D en crée une.</translation>
    </message>
    <message>
        <source>Without a guide curve the strategy makes one itself.</source>
        <translation>Sans courbe guide, la stratégie en crée une elle-même.</translation>
    </message>
    <message>
        <source>This strategy reads a path from a file, which is chosen in its parameters.</source>
        <translation>Cette stratégie lit une trajectoire dans un fichier, choisi dans ses paramètres.</translation>
    </message>
</context>
<context>
    <name>wcam::gui::ParamForm</name>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>au moins %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>au plus %1</translation>
    </message>
    <message>
        <source>Default: %1</source>
        <translation>Par défaut : %1</translation>
    </message>
    <message>
        <source>Search parameters</source>
        <translation>Chercher un paramètre</translation>
    </message>
    <message>
        <source>Level of the parameters shown</source>
        <translation>Niveau des paramètres affichés</translation>
    </message>
    <message>
        <source>Basic</source>
        <translation>Simple</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Avancé</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>Expert</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>Rien n’est choisi</translation>
    </message>
    <message>
        <source>Back to the default</source>
        <translation>Revenir à la valeur par défaut</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>Réinitialiser %1</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Choisir un fichier</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (absent)</translation>
    </message>
    <message>
        <source>Counted from 1</source>
        <translation>Compté à partir de 1</translation>
    </message>
</context>
<context>
    <name>wcam::gui::ProcessPlot</name>
    <message>
        <source>What is plotted</source>
        <translation>Grandeur tracée</translation>
    </message>
    <message>
        <source>Height and distance</source>
        <translation>Hauteur et distance</translation>
    </message>
    <message>
        <source>Travel and TCP speed</source>
        <translation>Vitesses d’avance et du TCP</translation>
    </message>
    <message>
        <source>Wire feed</source>
        <translation>Fil</translation>
    </message>
    <message>
        <source>Bead width</source>
        <translation>Largeur de cordon</translation>
    </message>
    <message>
        <source>Tilt and overhang</source>
        <translation>Inclinaison et surplomb</translation>
    </message>
    <message>
        <source>Margins</source>
        <translation>Marges</translation>
    </message>
</context>
<context>
    <name>wcam::gui::ProgramView</name>
    <message>
        <source>Output</source>
        <translation>Sortie</translation>
    </message>
    <message>
        <source>File of the program</source>
        <translation>Fichier du programme</translation>
    </message>
    <message>
        <source>Program text</source>
        <translation>Texte du programme</translation>
    </message>
    <message>
        <source>The lines of this language are not tied to the path.</source>
        <translation>Les lignes de ce langage ne sont pas liées à la trajectoire.</translation>
    </message>
    <message>
        <source>… the rest is in the exported file</source>
        <translation>… la suite est dans le fichier exporté</translation>
    </message>
</context>
<context>
    <name>wcam::gui::ProjectTree</name>
    <message>
        <source>Project</source>
        <translation>Projet</translation>
    </message>
    <message>
        <source>Strategy: %1</source>
        <translation>Stratégie : %1</translation>
    </message>
    <message>
        <source>Cell: none</source>
        <translation>Cellule : aucune</translation>
    </message>
    <message>
        <source>Cell: %1</source>
        <translation>Cellule : %1</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Pièces</translation>
    </message>
    <message>
        <source>Substrates</source>
        <translation>Substrats</translation>
    </message>
    <message>
        <source>Guide curves</source>
        <translation>Courbes guides</translation>
    </message>
    <message>
        <source>Processes</source>
        <translation>Procédés</translation>
    </message>
    <message>
        <source>Operations</source>
        <translation>Opérations</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Sorties</translation>
    </message>
</context>
<context>
    <name>wcam::gui::Session</name>
    <message>
        <source>Bring files to the project</source>
        <translation>Amener les fichiers au projet</translation>
    </message>
    <message>
        <source>Regenerate</source>
        <translation>Recalculer</translation>
    </message>
</context>
<context>
    <name>wcam::gui::VtkWidget</name>
    <message>
        <source>3D view</source>
        <translation>Vue 3D</translation>
    </message>
</context>
</TS>
