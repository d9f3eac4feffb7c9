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
        <source>Tool frame of the torch (UT)</source>
        <translation>Repère outil de la torche (UT)</translation>
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
        <source>Ramp at the </source>
        <translation>Rampe </translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Degree of the polynomial</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polynomial in each bead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Positioner at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Redundancy</source>
        <translation type="unfinished"></translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Inverser</translation>
    </message>
    <message>
        <source>Robot in one plane, torch vertical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Sélection</translation>
    </message>
    <message>
        <source>Table turns evenly along the bead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table turns the point to one azimuth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table turns the tool axis to one azimuth</source>
        <translation type="unfinished"></translation>
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
        <source>The torch leans to the side.</source>
        <translation>La torche penche de côté.</translation>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn of the table per bead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Untwisted cable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What follows</source>
        <translation>Ce qui suit</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Où</translation>
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
        <source>Take the robot cell from a file</source>
        <translation>Prendre la cellule robot dans un fichier</translation>
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
        <source>Choose a cell</source>
        <translation>Choisir une cellule</translation>
    </message>
    <message>
        <source>Cells (*.json)</source>
        <translation>Cellules (*.json)</translation>
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
        <source>process %1 on %2</source>
        <translation>processus %1 sur %2</translation>
    </message>
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
